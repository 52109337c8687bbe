// The linear solver that suits a system: where contacts couple no strands, their factors solve it
// exactly; else conjugate gradients with these factors do. A sparse factorisation of the whole
// matrix was slower in every scene measured, from 2 strands to 500 and from none to 7,000 contacts.

#include <atomic>

#include "core/linear_solver.h"
#include "core/registry.h"

namespace ringlet {
namespace {

struct AutoParameters {
  Choice<LinearSolver> coupled = "pcg";

  static Schema<AutoParameters> schema() {
    return Schema<AutoParameters>().key("coupled", &AutoParameters::coupled, "", any_number(),
                                        "for systems in which contacts couple strands; must solve "
                                        "those in which none do without iterating");
  }
};

class Auto final : public LinearSolver {
 public:
  explicit Auto(const AutoParameters& parameters)
      : name_(parameters.coupled.type()), solver_(parameters.coupled.make()) {}

  void bind(const StrandGroups& groups) override { solver_->bind(groups); }
  std::size_t bytes() const override { return solver_->bytes(); }
  const BandFactor* band_factor() const override { return solver_->band_factor(); }
  bool prepare_rows(const GroupSystem& system, RowRange rows, std::span<Vector3<Pack>> x) override {
    // Threads share this: looked at before it is written.
    if (!has_prepared_.load(std::memory_order_relaxed)) has_prepared_ = true;
    return solver_->prepare_rows(system, rows, x);
  }
  bool prepare(const SystemMatrix& a) override {
    ++(a.couples_strands() ? coupled_systems_ : loose_systems_);
    return solver_->prepare(a);
  }
  SolveReport solve(const VertexField& b, VertexField& x) override { return solver_->solve(b, x); }

  std::string account() const override {
    std::string text;
    if (loose_systems_ + coupled_systems_ == 0 && has_prepared_) {
      text = "every system by the factors of its strands: nothing couples any";
    }
    if (loose_systems_ > 0) {
      text = std::to_string(loose_systems_) +
             " systems by the factors of their strands: no contact coupled any";
    }
    if (coupled_systems_ > 0) {
      if (!text.empty()) text += "; ";
      text +=
          std::to_string(coupled_systems_) + " systems by " + name_ + ": contacts coupled strands";
    }
    return text;
  }

 private:
  std::string name_;
  std::unique_ptr<LinearSolver> solver_;
  int loose_systems_ = 0, coupled_systems_ = 0;  ///< that were prepared as a whole
  std::atomic<bool> has_prepared_ = false;
};

}  // namespace

void register_auto(Registry& registry);
void register_auto(Registry& registry) {
  registry.of<LinearSolver>().add<AutoParameters>(
      "auto",
      {"the factors of the strands where no contact couples them, else conjugate gradients", "",
       ""},
      [](const AutoParameters& parameters) { return std::make_unique<Auto>(parameters); });
}

}  // namespace ringlet
