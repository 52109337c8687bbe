#include "core/verify/verify_energy.h"
#include "energies/modules.h"
#include "tests/catch.h"
#include "tests/energies/wrong_bending.h"

using namespace ringlet;

namespace {

/// The claims that do not hold.
std::vector<std::string> broken(const char* mistake) {
  Registry registry;
  register_energy<WrongBending>(registry, "wrong", {});
  const Json choice{{"type", "wrong"}, {"mistake", mistake}};
  std::vector<std::string> texts;
  for (const Claim& claim : verify_energy(energy_maker(registry, choice), {.trials = 3})) {
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

TEST_CASE("nothing is found wrong with a right energy") { CHECK(broken("none").empty()); }

TEST_CASE("a gradient of the wrong sign is found") {
  CHECK(contains(broken("sign"), "the gradient is the derivative of the value"));
}

TEST_CASE("a missing factor is found") {
  const auto claims = broken("factor");
  CHECK(contains(claims, "the Hessian is the derivative of the gradient"));
  CHECK_FALSE(contains(claims, "the gradient is the derivative of the value"));
}

TEST_CASE("an energy that depends on where the strand is is found") {
  const auto claims = broken("not_invariant");
  CHECK(contains(claims, "translations change nothing"));
  CHECK(contains(claims, "rotations turn gradient and Hessian"));
}

TEST_CASE("an energy that holds another load than it was asked to is found") {
  CHECK(contains(broken("hold"), "elements that hold a load pull in proportion to it"));
}

TEST_CASE("an energy that is not a number where the strand is straight is found") {
  CHECK(contains(broken("nan_when_straight"), "finite in degenerate states"));
}

TEST_CASE("forces at rest are found") {
  CHECK(contains(broken("rest"), "at rest there is no force"));
}

TEST_CASE("lanes that do something else than plain doubles are found") {
  CHECK(contains(broken("lanes"), "lanes compute what plain doubles do"));
}

TEST_CASE("a filter that leaves negative eigenvalues is found") {
  CHECK(contains(broken("indefinite"), "tight: positive semi-definite"));
}

TEST_CASE("an energy without any stiffness is refused") {
  Registry registry;
  register_energy<WrongBending>(registry, "wrong", {});
  const Json choice{{"type", "wrong"}, {"mistake", "zero"}};
  CHECK_THROWS_WITH(verify_energy(energy_maker(registry, choice), {}),
                    Catch::Contains("random strands of 2 to 8 vertices is 0"));
}
