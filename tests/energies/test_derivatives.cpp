#include "tests/catch.h"
#include "tests/energies/probe.h"
#include "tests/energies/textbook.h"

using namespace ringlet;
using namespace ringlet::test;

namespace {

constexpr int trials = 40;

/// check(name, rest shape, positions) for random elements of every energy and shape.
template <class Check>
void for_random_elements(double nearly, const Check& check) {
  const unsigned seed = 7;
  std::mt19937 random(seed);
  for (const std::string& name : elastic_names) {
    for (const Shape shape : all_shapes) {
      for (int trial = 0; trial < trials; ++trial) {
        const Points rest = random_stencil(random, vertices_of(name), Shape::generic);
        const Points x = random_stencil(random, vertices_of(name), shape, nearly);
        INFO(name << ", shape " << static_cast<int>(shape) << ", trial " << trial << ", seed "
                  << seed);
        check(name, rest, x);
      }
    }
  }
}

Eigen::MatrixXd differences_of_gradient(const Bound& energy, const Points& x, double step) {
  Eigen::MatrixXd hessian(x.size(), x.size());
  Points moved = x;
  for (int i = 0; i < x.size(); ++i) {
    moved.reshaped()(i) = x.reshaped()(i) + step;
    const Eigen::VectorXd above = energy.at(moved).gradient;
    moved.reshaped()(i) = x.reshaped()(i) - step;
    hessian.col(i) = (above - energy.at(moved).gradient) / (2 * step);
    moved.reshaped()(i) = x.reshaped()(i);
  }
  return hessian;
}

double relative_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

}  // namespace

TEST_CASE("value and gradient are those of the textbook") {
  for_random_elements(0.02, [](const std::string& name, const Points& rest, const Points& x) {
    const Bound energy(name, rest);
    const Textbook textbook(name, rest, plain_material());
    const Probe probe = energy.at(x);
    REQUIRE(probe.value > 0);
    CHECK(probe.value == Approx(double(textbook.value(x.cast<long double>()))).epsilon(1e-12));
    CHECK(energy.value(x) == Approx(probe.value).epsilon(1e-13));
    CHECK(relative_difference(probe.gradient, textbook.gradient(x)) < 1e-6);
  });
}

TEST_CASE("the exact Hessian is the derivative of the gradient") {
  for_random_elements(0.02, [](const std::string& name, const Points& rest, const Points& x) {
    const Bound energy(name, rest);
    CHECK(relative_difference(energy.at(x).hessian, differences_of_gradient(energy, x, 1e-6)) <
          1e-6);
  });
}

TEST_CASE("closed forms agree with automatic differentiation of other formulas") {
  for_random_elements(1e-3, [](const std::string& name, const Points& rest, const Points& x) {
    const Probe closed_form = Bound(name, rest).at(x);
    const Bound twin(make_twin(name, "exact"), {int(rest.cols())}, rest);
    const Probe automatic = twin.at(x);
    CHECK(closed_form.value == Approx(automatic.value).epsilon(1e-11));
    CHECK(relative_difference(closed_form.gradient, automatic.gradient) < 1e-9);
    CHECK(relative_difference(closed_form.hessian, automatic.hessian) < 1e-8);
  });
}

TEST_CASE("the stiffness of an energy follows from the material and the radii") {
  std::mt19937 random(3);
  const Points rest = random_stencil(random, 4, Shape::generic);
  const Points x = random_stencil(random, 4, Shape::generic);
  Material tapered = plain_material();
  tapered.tip_radius = 1e-2;
  for (const std::string& name : elastic_names) {
    const int count = vertices_of(name);
    const Points short_rest = rest.leftCols(count), short_x = x.leftCols(count);
    const Bound energy(make_energy(name), {count}, short_rest, tapered);
    Material uniform = plain_material();
    const Strands& strands = energy.strands();
    uniform.radius = name == "stretch"   ? 0.5 * (strands.radius(0) + strands.radius(1))
                     : name == "bending" ? strands.radius(1)
                                         : 0.5 * (strands.radius(1) + strands.radius(2));
    const Textbook textbook(name, short_rest, uniform);
    CHECK(energy.value(short_x) ==
          Approx(double(textbook.value(short_x.cast<long double>()))).epsilon(1e-12));
  }
}

TEST_CASE("energies are at rest in their rest shape and do not see rigid motions") {
  std::mt19937 random(11);
  for (const std::string& name : elastic_names) {
    const Points rest = random_points(random, 12), x = random_points(random, 12);
    for (const char* filter : {"exact", "tight"}) {
      const Bound energy(name, rest, filter);
      const Probe at_rest = energy.at(rest), moved = energy.at(x);
      REQUIRE(moved.gradient.norm() > 0);
      CHECK(at_rest.value < 1e-25 * moved.value);
      CHECK(at_rest.gradient.norm() < 1e-12 * moved.gradient.norm());

      const Eigen::Matrix3d rotation = random_rotation(random);
      const Points turned = (rotation * x).colwise() + Eigen::Vector3d(0.3, -2, 1);
      const Probe after = energy.at(turned);
      CHECK(after.value == Approx(moved.value).epsilon(1e-12));
      const Points expected = rotation * moved.gradient.reshaped(3, 12);
      CHECK(relative_difference(after.gradient, expected.reshaped()) < 1e-10);
      // Translations are in the null space.
      const Points shift = Eigen::Vector3d(1, 2, 3).replicate(1, 12);
      CHECK((moved.hessian * shift.reshaped()).norm() < 1e-12 * moved.hessian.norm());
    }
  }
}
