#include "solvers/newton.h"

#include <cmath>

#include "core/registry.h"
#include "core/stiffest_vertex.h"

namespace ringlet {
namespace {

/// What stands in the way of an outcome, in words; empty: nothing.
std::string describe_failure(const NewtonOutcome& outcome, const PotentialTerms& terms,
                             const Model& model, double dt, const VertexField& x) {
  using Failure = NewtonOutcome::Failure;
  std::string otherwise;
  if (outcome.failure == Failure::not_finite) {
    otherwise = "a force or contact is not finite";
  } else if (outcome.failure == Failure::no_direction) {
    otherwise =
        "the linear solver found no direction in which the potential falls, even with mass "
        "added: " +
        describe_stiffest_vertex(model, x, dt).value_or("no energy resists") +
        "; longer edges, a smaller radius or modulus, or a smaller dt may help";
  } else if (!std::isfinite(terms.total())) {
    otherwise = "the potential is not finite after the update";
  } else {
    return {};
  }
  return "Newton iteration " + std::to_string(outcome.iterations) + ": " +
         find_non_finite(model, x).value_or(otherwise);
}

}  // namespace

void Newton::bind(const Model& model) {
  matrix_.emplace(model.groups);
  if (SeparateStrands::suit(model)) {
    separate_.emplace().bind(model);
  } else {
    coupled_.emplace().bind(model);
  }
}

std::size_t Newton::bytes() const {
  return (matrix_ ? matrix_->bytes() : 0) + (separate_ ? separate_->bytes() : 0) +
         (coupled_ ? coupled_->bytes() : 0);
}

void Newton::minimise(Model& model, IncrementalPotential& potential, double dt, VertexField& x,
                      StepReport& report) {
  const NewtonStep step{model, potential, *matrix_, dt, report};
  const auto run = [&](auto& strands) {
    const NewtonOutcome outcome = strands.minimise(parameters_, step, x);
    take_outcome(outcome, strands.terms(), step, x);
  };
  separate_ ? run(*separate_) : run(*coupled_);
  if (!report.failure.empty() || !model.collision) return;
  const StageTimer timer(report.seconds.detect);
  naming(*model.collision, [&] {
    model.collision->end_step(x);
    report.contacts = model.collision->report();
  });
}

void Newton::take_outcome(const NewtonOutcome& outcome, const PotentialTerms& terms,
                          const NewtonStep& step, const VertexField& x) const {
  StepReport& report = step.report;
  report.newton_iterations = outcome.iterations;
  report.newton_converged = outcome.converged;
  report.newton_update = outcome.update;
  report.line_search_halvings = outcome.halvings;
  report.failure = describe_failure(outcome, terms, step.model, step.dt, x);
  report.contact_energy = terms.contacts;
  report.energies = terms.energies;
  report.energies.insert(report.energies.end(), terms.couplings.begin(), terms.couplings.end());
}

}  // namespace ringlet
