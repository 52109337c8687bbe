#include "tests/catch.h"
#include "tests/energies/textbook.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

constexpr int trials = 40;

/// check(name, rest shape, positions) for random elements of every energy and shape.
template <class Check>
void for_random_elements(double nearly, const Check& check) {
  const unsigned seed = 7;
  std::mt19937_64 random(seed);
  for (const std::string& name : elastic_names) {
    for (const Shape shape : all_shapes) {
      for (int trial = 0; trial < trials; ++trial) {
        const Points rest = random_strand(random, vertices_of(name), Shape::generic);
        const Points x = random_strand(random, vertices_of(name), shape, nearly);
        INFO(name << ", shape " << static_cast<int>(shape) << ", trial " << trial << ", seed "
                  << seed);
        check(name, rest, x);
      }
    }
  }
}

double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("value and gradient are those of the textbook") {
  for_random_elements(0.02, [](const std::string& name, const Points& rest, const Points& x) {
    const BoundEnergy energy = bound(name, rest);
    const Textbook textbook(name, rest, plain_material());
    const Probe probe = energy.at(x);
    REQUIRE(probe.value > 0);
    CHECK(probe.value == Approx(double(textbook.value(x.cast<long double>()))).epsilon(1e-12));
    CHECK(energy.value(x) == Approx(probe.value).epsilon(1e-12));
    CHECK(difference(probe.gradient, textbook.gradient(x)) < 1e-6);
  });
}

TEST_CASE("closed forms agree with automatic differentiation of other formulas") {
  for_random_elements(1e-3, [](const std::string& name, const Points& rest, const Points& x) {
    const Probe closed_form = bound(name, rest).at(x);
    const BoundEnergy twin(make_twin(name, "exact"), rest);
    const Probe automatic = twin.at(x);
    CHECK(closed_form.value == Approx(automatic.value).epsilon(1e-11));
    CHECK(difference(closed_form.gradient, automatic.gradient) < 1e-9);
    CHECK(difference(closed_form.hessian, automatic.hessian) < 1e-8);
  });
}

TEST_CASE("the stiffness of an energy follows from the material and the radii") {
  std::mt19937_64 random(3);
  const Points rest = random_strand(random, 4, Shape::generic);
  const Points x = random_strand(random, 4, Shape::generic);
  Material tapered = plain_material();
  tapered.tip_radius = 1e-2;
  for (const std::string& name : elastic_names) {
    const int count = vertices_of(name);
    const Points short_rest = rest.leftCols(count), short_x = x.leftCols(count);
    const BoundEnergy energy(make_energy(name), {count}, short_rest, tapered);
    Material uniform = plain_material();
    const Strands& strands = energy.strands();
    uniform.radius = name == "stretch" ? 0.5 * (strands.radius(0) + strands.radius(1))
                     : name == "twist" ? 0.5 * (strands.radius(1) + strands.radius(2))
                                       : strands.radius(1);
    const Textbook textbook(name, short_rest, uniform);
    CHECK(energy.value(short_x) ==
          Approx(double(textbook.value(short_x.cast<long double>()))).epsilon(1e-12));
  }
}
