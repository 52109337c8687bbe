// An energy may have an unknown of its own for every edge, as the twist of a material frame is, by
// minimising over it: E(x) = min over theta of E(x, theta).

#include "core/energy.h"
#include "core/registry.h"
#include "core/verify/verify_energy.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

constexpr double outer = 3, inner = 2;  // stiffness, J

/// A spring along each edge in series with another one, whose strain theta is the unknown:
///
///     E(x, theta) = a/2 (|e|/l - 1 - theta)^2 + b/2 theta^2
class Series final : public Energy {
 public:
  void bind(const Strands& strands, const StrandGroups& groups) override {
    groups_ = &groups;
    stiff_.assign(groups.rows(), Pack(0));
    inverse_length_.assign(groups.rows(), Pack(1));
    for (int v = 0; v + 1 < strands.vertex_count(); ++v) {
      // An edge without rest length has no strain.
      const bool is_edge = strands.strand_of(v) == strands.strand_of(v + 1);
      if (!is_edge || strands.rest_length(v) < 1e-150) continue;
      const auto [row, lane] = groups.slot(v);
      stiff_[row][lane] = 1;
      inverse_length_[row][lane] = 1 / strands.rest_length(v);
    }
  }

  double add(int group, std::span<const Vector3<Pack>> x, EdgeOutputs outputs) const override {
    const int first = (*groups_)[group].first_row;
    Pack energy = 0;
    for (int i = 0; i + 1 < static_cast<int>(x.size()); ++i) {
      const Vector3<Pack> edge = x[i + 1] - x[i];
      const Pack length = norm(edge), strain = length * inverse_length_[first + i] - 1;
      const Pack theta = outer / (outer + inner) * strain;
      energy += stiff_[first + i] * 0.5 *
                (outer * (strain - theta) * (strain - theta) + inner * theta * theta);
      const auto safe = length > 0;
      const Vector3<Pack> t =
          Pack(select(safe, Pack(1 / select(safe, length, Pack(1))), Pack(0))) * edge;
      const Pack tension =
          stiff_[first + i] * outer * (strain - theta) * inverse_length_[first + i];
      if (!outputs.gradient.empty()) outputs.gradient[i] += tension * t;
      if (outputs.hessian.empty()) continue;
      // Of E(x, theta) at that theta: never less than what is left when theta follows.
      const Pack along =
          stiff_[first + i] * outer * inverse_length_[first + i] * inverse_length_[first + i];
      const Pack across =
          select(safe, Pack(max(tension, Pack(0)) / select(safe, length, Pack(1))), Pack(0));
      Matrix3<Pack>& block = outputs.hessian.block(i, 0);
      add_outer_product(block, Pack(along - across) * t, t);
      for (int c = 0; c < 3; ++c) block(c, c) += across;
    }
    return sum_lanes(energy);
  }

 private:
  const StrandGroups* groups_ = nullptr;
  VertexScalars stiff_, inverse_length_;
};

}  // namespace

TEST_CASE("an energy with an unknown of its own an edge has the derivatives of its minimum") {
  Registry registry;
  registry.of<Energy>().add<NoParameters>(
      "series", {}, [](const NoParameters&) { return std::make_unique<Series>(); });
  int seen = 0;
  for (const Claim& claim : verify_energy(energy_maker(registry, "series"), {.trials = 3})) {
    // Its Hessian is a majorant of the one of the minimum, not this itself.
    if (claim.text == "the Hessian is the derivative of the gradient") continue;
    INFO(claim.text << ": " << claim.worst << " of " << claim.allowed << " in "
                    << claim.worst_state);
    CHECK((claim.states == 0 || claim.holds()));
    ++seen;
  }
  CHECK(seen > 5);
}
