#include <Eigen/Eigenvalues>

#include "collision/friction.h"
#include "core/system_matrix.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

/// Two edges that touch at a point, and friction that has seen them.
struct Touch {
  Strands strands{{2, 2}, {{-1, 0, 0}, {1, 0, 0}, {0.2, -1, 0.05}, {0.1, 1, 0.05}}, Material{}};
  StrandGroups groups{strands};
  VertexField x_n = positions_with_pads(groups, rest_positions(strands));
  Friction friction{0.5, 0.3, 0.1};
  Contact contact;

  Touch() {
    friction.begin_step(x_n, 0.01);
    contact = {{0, 1, 2, 3}, {0.425, 0.575, -0.5, -0.5}, {0, 0, 1}, 0.05, {1, -2, 3}};
  }
  VertexField moved(double by) const {
    std::mt19937 random(47);
    VertexField x = x_n;
    for (int v = 0; v < 4; ++v) x.add(v, random_point(random, by));
    return x;
  }
  VertexField gradient_at(const VertexField& x) const {
    VertexField gradient(groups);
    Couplings couplings(groups);
    friction.add(x, &couplings);
    couplings.finish(VertexScalars(groups.rows(), Pack(1)));
    couplings.add_gradient(0, gradient.group(0));
    return gradient;
  }
  Eigen::MatrixXd hessian_at(const VertexField& x) const {
    SystemMatrix matrix(groups);
    matrix.keep_bands();
    friction.add(x, &matrix.couplings);
    matrix.couplings.finish(VertexScalars(groups.rows(), Pack(1)));
    matrix.couplings.add_to_bands(0, matrix.bands.group(0));
    Eigen::MatrixXd dense(12, 12);
    for (int column = 0; column < 12; ++column) {
      VertexField unit(groups), product(groups);
      unit.set(column / 3, Eigen::Vector3d::Unit(column % 3));
      multiply(matrix, unit, product);
      dense.col(column) = product.matrix().reshaped();
    }
    return dense;
  }
};

}  // namespace

TEST_CASE("friction's gradient and Hessian are those of differences, and semi-definite") {
  Touch touch;
  touch.friction.add_strand_contact(touch.contact);
  const double by = GENERATE(2e-4, 1e-2);  // sticking, sliding
  const VertexField x = touch.moved(by), gradient = touch.gradient_at(x);
  const Eigen::MatrixXd hessian = touch.hessian_at(x);
  CHECK(gradient.matrix().norm() > 0.01);
  CHECK(hessian.norm() > 1);
  const double step = 1e-4 * by;
  for (int column = 0; column < 12; ++column) {
    VertexField plus = x, minus = x;
    plus.add(column / 3, step * Eigen::Vector3d::Unit(column % 3));
    minus.add(column / 3, -step * Eigen::Vector3d::Unit(column % 3));
    const double difference =
        (touch.friction.add(plus, nullptr) - touch.friction.add(minus, nullptr)) / (2 * step);
    CHECK(gradient.get(column / 3)[column % 3] == Approx(difference).margin(1e-6));
    const Eigen::VectorXd slope =
        (touch.gradient_at(plus).matrix() - touch.gradient_at(minus).matrix()).reshaped() /
        (2 * step);
    CHECK((hessian.col(column) - slope).norm() < 1e-5 * hessian.norm());
  }
  const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(hessian).eigenvalues();
  CHECK(eigenvalues.minCoeff() > -1e-12 * eigenvalues.maxCoeff());
}

TEST_CASE("sliding friction is mu times the normal force, whatever the speed") {
  Touch touch;
  touch.friction.add_strand_contact(touch.contact);
  for (const double by : {2e-3, 1e-2}) {
    VertexField x = touch.x_n;
    for (const int v : {0, 1}) x.add(v, {by, 0, 0.3});  // what is along the normal does not count
    const VertexField gradient = touch.gradient_at(x);
    const Eigen::Vector3d force = gradient.get(0) + gradient.get(1);
    CHECK((force - Eigen::Vector3d(0.5 * 2, 0, 0)).norm() < 1e-9);
    CHECK((force + gradient.get(2) + gradient.get(3)).norm() < 1e-12);
  }
}

TEST_CASE("friction carries strands along with what moves") {
  Touch touch;
  touch.contact.weights = {1, 0, 0, 0};
  touch.friction.add_collider_contact(touch.contact, {0.01, 0, 0});
  CHECK((touch.gradient_at(touch.x_n).get(0) - Eigen::Vector3d(-0.3 * 2, 0, 0)).norm() < 1e-9);
  VertexField carried = touch.x_n;
  carried.add(0, {0.01, 0, 0});
  CHECK(touch.gradient_at(carried).get(0).norm() < 1e-12);
}
