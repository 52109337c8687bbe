#include "core/batch_energy.h"
#include "core/verify/probe.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

/// A spring whose rest length creeps towards its length, and is driven by time besides.
struct Creeping {
  using Parameters = NoParameters;
  static constexpr int vertices = 2;
  template <class S>
  struct Rest {
    S stiffness, length, creep;
  };
  NoParameters parameters;

  Rest<double> rest(const ElementRest<2>& element) const { return {2, element.lengths[0], 0}; }
  template <class S>
  S value(const Stencil<S, 2>& x, const Rest<S>& rest) const {
    const S stretch = norm(x[1] - x[0]) - rest.length;
    return S(0.5) * rest.stiffness * stretch * stretch;
  }
  template <class S>
  Rest<S> update(const Stencil<S, 2>& x, const Rest<S>& rest, const StepTime& time) const {
    const S creep = S(0.5) * (norm(x[1] - x[0]) - rest.length);
    return {rest.stiffness, rest.length + creep + S(time.end + 10 * time.dt), creep};
  }
};

struct Begun {
  explicit Begun(Evaluation evaluation)
      : strands({2, 3}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {0, 2, 0}, {0, 4, 0}}, Material{}),
        groups(strands),
        energy(Creeping{}, Filter::tight, evaluation),
        state{0.25, positions_with_pads(groups, moved), VertexField(groups)} {
    energy.bind(strands, groups);
  }
  double value() const { return energy.add(0, state.positions.group(0), {}); }

  // Lengths 3, 2 and 2 where they were 1, 2 and 2.
  std::vector<Eigen::Vector3d> moved{{0, 0, 0}, {3, 0, 0}, {0, 0, 0}, {0, 2, 0}, {0, 4, 0}};
  Strands strands;
  StrandGroups groups;
  BatchEnergy<Creeping> energy;
  State state;
};

}  // namespace

TEST_CASE("a kernel may change its rest data when a step begins") {
  for (const Evaluation evaluation : {Evaluation::lanes, Evaluation::scalar}) {
    Begun begun(evaluation);
    CHECK(begun.value() == Approx(4));
    begun.energy.begin_step({begun.state, 0.125, {}, {begun.state.positions, 0.125}});
    // Rest lengths 1 + 1 + 1.625, and 2 + 1.625 twice.
    CHECK(begun.value() == Approx(0.625 * 0.625 + 2 * 1.625 * 1.625));
  }
}
