#include "core/batch_energy.h"
#include "core/verify/verify_energy.h"
#include "energies/modules.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

/// Bending by the angle of two edges, wrong in one of several ways.
enum class Wrong { nothing, sign, factor, not_invariant, nan_when_straight, zero, rest };

template <Wrong wrong>
struct WrongBending {
  using Parameters = NoParameters;
  static constexpr int vertices = 3;
  template <class S>
  struct Rest {
    S stiffness, angle;
  };
  NoParameters parameters;

  template <class S>
  static S angle(const Stencil<S, 3>& x) {
    const Vector3<S> e0 = x[1] - x[0], e1 = x[2] - x[1];
    const S sine = norm(cross(e0, e1));
    if constexpr (wrong == Wrong::nan_when_straight) {
      return atan2(sine, dot(e0, e1)) * (sine / sine);
    }
    return atan2(sine, dot(e0, e1));
  }
  Rest<double> rest(const ElementRest<3>& element) const {
    const double at_rest = angle<double>(element.positions);
    return {wrong == Wrong::zero ? 0.0 : 1.0, wrong == Wrong::rest ? at_rest + 0.1 : at_rest};
  }
  template <class S>
  S value(const Stencil<S, 3>& x, const Rest<S>& rest) const {
    const S difference = angle(x) - rest.angle;
    S energy = 0.5 * rest.stiffness * difference * difference;
    if constexpr (wrong == Wrong::not_invariant) energy += rest.stiffness * x[0].x * difference;
    return energy;
  }
  template <class S>
  S evaluate(const Stencil<S, 3>& x, const Rest<S>& rest, Filter filter,
             ElementOutputs<S, 3> outputs) const {
    Derivatives<S, 3> derivatives;
    const S energy = evaluate_by_autodiff(*this, x, rest, derivatives.outputs());
    if (wrong == Wrong::sign) {
      for (Vector3<S>& slope : derivatives.gradient) slope = -slope;
    }
    if (wrong == Wrong::factor) {
      for (Matrix3<S>& block : derivatives.blocks) block = S(2) * block;
    }
    if (filter != Filter::exact) filter_eigenvalues(Filter::clamp, derivatives);
    derivatives.add_to(outputs);
    return energy;
  }
};

/// The claims that do not hold.
template <Wrong wrong>
std::vector<std::string> broken() {
  Registry registry;
  register_energy<WrongBending<wrong>>(registry, "wrong", {});
  std::vector<std::string> texts;
  for (const Claim& claim : verify_energy(energy_maker(registry, "wrong"), {.trials = 3})) {
    if (!claim.holds()) texts.push_back(claim.text);
  }
  return texts;
}

bool contains(const std::vector<std::string>& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

}  // namespace

TEST_CASE("every energy keeps what it promises") {
  Registry registry;
  register_energies(registry);
  for (const std::string& name : registry.of<Energy>().names()) {
    for (const Claim& claim : verify_energy(energy_maker(registry, name), {.trials = 3})) {
      INFO(name << ", " << claim.text << ": " << claim.worst << " of " << claim.allowed << " in "
                << claim.worst_state);
      CHECK(claim.holds());
    }
  }
}

TEST_CASE("nothing is found wrong with a right energy") { CHECK(broken<Wrong::nothing>().empty()); }

TEST_CASE("a gradient of the wrong sign is found") {
  CHECK(contains(broken<Wrong::sign>(), "the gradient is the derivative of the value"));
}

TEST_CASE("a missing factor is found") {
  const auto claims = broken<Wrong::factor>();
  CHECK(contains(claims, "the Hessian is the derivative of the gradient"));
  CHECK_FALSE(contains(claims, "the gradient is the derivative of the value"));
}

TEST_CASE("an energy that depends on where the strand is is found") {
  const auto claims = broken<Wrong::not_invariant>();
  CHECK(contains(claims, "translations change nothing"));
  CHECK(contains(claims, "rotations turn gradient and Hessian"));
}

TEST_CASE("an energy that is not a number where the strand is straight is found") {
  CHECK(contains(broken<Wrong::nan_when_straight>(), "finite in degenerate states"));
}

TEST_CASE("forces at rest are found") {
  CHECK(contains(broken<Wrong::rest>(), "at rest there is no force"));
}

TEST_CASE("an energy without any stiffness is refused") {
  Registry registry;
  register_energy<WrongBending<Wrong::zero>>(registry, "zero", {});
  CHECK_THROWS_WITH(verify_energy(energy_maker(registry, "zero"), {}),
                    Catch::Contains("random strands of 2 to 8 vertices is 0"));
}
