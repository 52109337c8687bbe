// Divides every step of another integrator until it is accurate enough. A step of tau and two of
// tau / 2 lead to positions whose difference tells the error of the latter (Richardson; Hairer,
// Norsett, Wanner: Solving Ordinary Differential Equations I, section II.4): with the order p
//
//     error = max over the vertices of |x(tau) - x(tau/2, tau/2)| / (2^p - 1).
//
// The two are kept where it is at most tolerance tau / dt, so that the errors of all parts of a
// step add up to no more than the tolerance. Where it is larger, and where the integrator fails or
// Newton's method does not converge, tau is halved; where it is small enough, doubled. All tau are
// dt / 2^k, so that the end of the step is met.

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "core/changing_data.h"
#include "core/integrator.h"
#include "core/parallel.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct AdaptiveParameters {
  Choice<Integrator> integrator{"bdf2"};
  double tolerance = 1e-4;
  int halvings = 10;

  static Schema<AdaptiveParameters> schema() {
    return Schema<AdaptiveParameters>()
        .key("integrator", &AdaptiveParameters::integrator, "", any_number(),
             "what is divided; its dt is the longest step, after which observers look")
        .key("tolerance", &AdaptiveParameters::tolerance, "m", positive(),
             "largest error in the position of a vertex that a step of this dt may add")
        .key("halvings", &AdaptiveParameters::halvings, "", between(0, 20),
             "the smallest step is dt / 2^halvings");
  }
};

/// A part of the tolerance below which twice the step is tried.
constexpr double growth_safety = 0.5;

std::string in_words(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

/// The largest distance between two positions of a vertex, m.
double largest_distance(const VertexField& a, const VertexField& b) {
  std::vector<double> squared(a.groups().count());
  parallel_for_each(a.groups().count(), [&](int g) {
    const auto rows_a = a.group(g), rows_b = b.group(g);
    Pack largest = 0;
    for (std::size_t i = 0; i < rows_a.size(); ++i) {
      largest = max(largest, squared_norm(rows_a[i] - rows_b[i]));
    }
    squared[g] = std::experimental::hmax(largest);
  });
  return squared.empty() ? 0 : std::sqrt(*std::max_element(squared.begin(), squared.end()));
}

/// What a part of a step took, whether it is kept or not.
void add_work(StepReport& total, const StepReport& part) {
  total.newton_iterations += part.newton_iterations;
  total.linear_iterations += part.linear_iterations;
  total.line_search_halvings += part.line_search_halvings;
  total.seconds += part.seconds;
}

/// What a part that is kept says of the step, of which it is the last so far.
void add_result(StepReport& total, StepReport part) {
  ++total.substeps;
  total.newton_converged &= part.newton_converged;
  total.linear_converged &= part.linear_converged;
  total.linear_residual = std::max(total.linear_residual, part.linear_residual);
  total.newton_update = part.newton_update;
  total.energies = std::move(part.energies);
  total.contact_energy = part.contact_energy;
  total.kinetic_energy = part.kinetic_energy;
  total.contacts = part.contacts;
}

/// Where a step stands, in units of its smallest part.
class Division {
 public:
  /// The step before ended with two parts of the given length, s; 0: there was none.
  Division(int halvings, double dt, double last_part)
      : dt_(dt), total_(1L << halvings), part_(total_) {
    // One attempt with parts twice as long as the last ones.
    while (last_part > 0 && part_ > 1 && length() > 5 * last_part) halve();
  }
  bool is_done() const { return done_ == total_; }
  bool is_smallest() const { return part_ == 1; }
  /// Of the part that comes next, s.
  double length() const { return fraction() * dt_; }
  double fraction() const { return static_cast<double>(part_) / static_cast<double>(total_); }
  void halve() { part_ /= 2; }
  void advance() { done_ += part_; }
  void grow() {
    if (part_ < total_ && done_ % (2 * part_) == 0) part_ *= 2;
  }

 private:
  double dt_;
  long total_, part_, done_ = 0;
};

class Adaptive final : public Integrator {
 public:
  explicit Adaptive(const AdaptiveParameters& parameters)
      : parameters_(parameters),
        integrator_(parameters.integrator.make()),
        error_scale_(std::ldexp(1.0, integrator_->order()) - 1) {}

  double time_step() const override { return integrator_->time_step(); }
  int order() const override { return integrator_->order(); }
  void bind(const Model& model) override {
    naming(*integrator_, [&] { integrator_->bind(model); });
  }

  std::size_t bytes() const override {
    std::size_t sum = integrator_->bytes() + at_start_.bytes() + before_.bytes();
    for (const State* state : {&reached_, &whole_, &first_, &second_}) sum += state->bytes();
    return sum;
  }

  StepReport step(Model& model, State& state, double dt) override {
    StepReport report;
    report.substeps = 0;
    report.newton_converged = true;
    at_start_.save(model);
    reached_ = state;
    is_whole_known_ = false;
    Division division(parameters_.halvings, dt, state.history.dt);
    while (report.failure.empty() && !division.is_done()) advance(model, division, report);
    if (!report.failure.empty()) {
      at_start_.restore(model);
      return report;
    }
    reached_.time = state.time + dt;
    std::swap(state, reached_);
    return report;
  }

 private:
  /// The next part: keeps it if it is good enough, else halves it; if that cannot be, the report
  /// says why.
  void advance(Model& model, Division& division, StepReport& report) {
    const double tau = division.length();
    before_.save(model);
    StepReport whole, first, second;
    const bool are_done = (is_whole_known_ || try_step(model, reached_, tau, whole_, whole)) &&
                          try_again(model, tau / 2, first_, first) &&
                          try_step(model, first_, tau / 2, second_, second);
    is_whole_known_ = false;
    for (const StepReport* part : {&whole, &first, &second}) add_work(report, *part);
    const bool have_converged =
        whole.newton_converged && first.newton_converged && second.newton_converged;
    if (are_done && (have_converged || division.is_smallest())) {
      judge(model, division, report, {std::move(first), std::move(second)});
    } else if (!division.is_smallest()) {
      before_.restore(model);
      division.halve();
    } else {
      report.failure = "in the smallest part of the step, " + in_words(tau / 2) +
                       " s: " + whole.failure + first.failure + second.failure;
    }
  }

  /// Keeps two halves of a part whose error is small enough, or cannot be smaller.
  void judge(Model& model, Division& division, StepReport& report,
             std::array<StepReport, 2> halves) {
    const double error = largest_distance(whole_.positions, second_.positions) / error_scale_;
    const double allowed = parameters_.tolerance * division.fraction();
    const bool is_met = error <= allowed;
    if (!is_met && !division.is_smallest()) {
      before_.restore(model);
      division.halve();
      // What was the first half is now the whole.
      std::swap(whole_, first_);
      is_whole_known_ = true;
      return;
    }
    for (StepReport& half : halves) add_result(report, std::move(half));
    report.local_error += error;
    report.local_error_met &= is_met;
    std::swap(reached_, second_);
    division.advance();
    // Of twice the length, the error is 2^(p+1) times as large, and twice as much is allowed.
    if (error * (error_scale_ + 1) <= growth_safety * allowed) division.grow();
  }

  bool try_again(Model& model, double dt, State& end, StepReport& report) {
    before_.restore(model);
    return try_step(model, reached_, dt, end, report);
  }
  bool try_step(Model& model, const State& start, double dt, State& end, StepReport& report) {
    end = start;
    report = naming(*integrator_, [&] { return integrator_->step(model, end, dt); });
    return report.failure.empty();
  }

  AdaptiveParameters parameters_;
  std::unique_ptr<Integrator> integrator_;
  double error_scale_;            ///< 2^p - 1
  State reached_;                 ///< at the end of the parts that are kept
  State whole_, first_, second_;  ///< after the next part as a whole, after its halves
  bool is_whole_known_ = false;
  ChangingData at_start_, before_;
};

}  // namespace

void register_adaptive(Registry& registry);
void register_adaptive(Registry& registry) {
  registry.of<Integrator>().add<AdaptiveParameters>(
      "adaptive",
      {"divides the steps of another integrator until their error is small enough",
       "max |x(tau) - x(tau/2, tau/2)| / (2^p - 1) <= tolerance tau / dt",
       "Hairer, Norsett, Wanner, section II.4"},
      [](const AdaptiveParameters& parameters) { return std::make_unique<Adaptive>(parameters); });
}

}  // namespace ringlet
