#include "tests/energies/textbook.h"

#include <Eigen/Geometry>

#include "core/batch_energy.h"

namespace ringlet::test {

namespace {

using LongPoints = Eigen::Matrix<long double, 3, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, 3, 1>;
const long double long_pi = std::acos(-1.0L);

struct StretchTwin {
  using Parameters = NoParameters;
  static constexpr int vertices = 2;
  template <class S>
  struct Rest {
    S stiffness, length;
  };
  NoParameters parameters;
  Rest<double> rest(const ElementRest<2>& e) const {
    return {e.material.youngs_modulus * circle_area(e.radii[0]) * e.lengths[0], e.lengths[0]};
  }
  template <class S>
  S value(const Stencil<S, 2>& x, const Rest<S>& rest) const {
    const S strain = norm(x[1] - x[0]) / rest.length - 1.0;
    return 0.5 * rest.stiffness * strain * strain;
  }
};

// theta = 2 atan2(|t0 - t1|, |t0 + t1|) (Kahan).
struct AngleMeasure {
  template <class S>
  static S of(const Vector3<S>& t0, const Vector3<S>& t1) {
    return 2.0 * atan2(norm(t0 - t1), norm(t0 + t1));
  }
};
struct TangentMeasure {
  template <class S>
  static S of(const Vector3<S>& t0, const Vector3<S>& t1) {
    return 2.0 * norm(t0 + t1) / norm(t0 - t1);
  }
};
struct SineMeasure {
  template <class S>
  static S of(const Vector3<S>& t0, const Vector3<S>& t1) {
    return norm(t0 + t1);
  }
};

template <class Measure>
struct BendingTwin {
  using Parameters = NoParameters;
  static constexpr int vertices = 3;
  template <class S>
  struct Rest {
    S stiffness, measure;
  };
  NoParameters parameters;
  template <class S>
  static S measure(const Stencil<S, 3>& x) {
    const Vector3<S> e0 = x[0] - x[1], e1 = x[2] - x[1];
    return Measure::of((1.0 / norm(e0)) * e0, (1.0 / norm(e1)) * e1);
  }
  Rest<double> rest(const ElementRest<3>& e) const {
    const double stiffness = e.material.youngs_modulus * circle_second_moment(e.radii[1]);
    return {2 * stiffness / (e.lengths[0] + e.lengths[1]), measure(e.positions)};
  }
  template <class S>
  S value(const Stencil<S, 3>& x, const Rest<S>& rest) const {
    const S difference = measure(x) - rest.measure;
    return 0.5 * rest.stiffness * difference * difference;
  }
};

// tau from the normals of the two planes.
struct TwistTwin {
  using Parameters = NoParameters;
  static constexpr int vertices = 4;
  template <class S>
  struct Rest {
    S stiffness, angle;
  };
  NoParameters parameters;
  template <class S>
  static S angle(const Stencil<S, 4>& x) {
    const Vector3<S> a = x[1] - x[0], b = x[2] - x[1], c = x[3] - x[2];
    const Vector3<S> n0 = cross(a, b), n1 = cross(b, c);
    const S cosine = -dot(n0, n1), sine = -norm(b) * dot(a, n1);
    return atan2(sine, cosine);
  }
  Rest<double> rest(const ElementRest<4>& e) const {
    return {e.material.shear() * circle_polar_moment(e.radii[1]) / e.lengths[1],
            angle(e.positions)};
  }
  template <class S>
  S value(const Stencil<S, 4>& x, const Rest<S>& rest) const {
    const S difference = wrap_angle(S(angle(x) - rest.angle));
    return 0.5 * rest.stiffness * difference * difference;
  }
};

}  // namespace

long double Textbook::measure(const LongPoints& x) const {
  if (name == "stretch") return (x.col(1) - x.col(0)).norm();
  const LongVector a = x.col(1) - x.col(0), b = x.col(2) - x.col(1);
  const long double turning = std::atan2(a.cross(b).norm(), a.dot(b));
  if (name == "bending") return long_pi - turning;
  if (name == "tan_bending") return 2 * std::tan(turning / 2);
  if (name == "sin_bending") return 2 * std::sin(turning / 2);
  // Seen along b, tau turns from the first edge, which leaves x1, to the last, which leaves x2.
  const LongVector c = x.col(3) - x.col(2);
  const LongVector axis = b.normalized();
  const LongVector u = axis.cross(-a), v = axis.cross(c);
  return std::atan2(axis.dot(u.cross(v)), u.dot(v));
}

Textbook::Textbook(const std::string& energy, const Points& rest_shape, const Material& material)
    : name(energy), rest(0) {
  const LongPoints x = rest_shape.cast<long double>();
  rest = measure(x);
  const long double r = material.radius, area = long_pi * r * r, inertia = area * r * r / 4;
  const long double youngs_modulus = material.youngs_modulus;
  if (name == "stretch") stiffness = youngs_modulus * area * rest;
  const auto length = [&](int i) { return (x.col(i + 1) - x.col(i)).norm(); };
  if (vertices_of(name) == 3) stiffness = youngs_modulus * inertia / ((length(0) + length(1)) / 2);
  if (name == "twist") stiffness = material.shear() * 2 * inertia / length(1);
}

long double Textbook::value(const LongPoints& x) const {
  long double difference = measure(x) - rest;
  if (name == "stretch") difference /= rest;
  if (name == "twist") difference = std::remainder(difference, 2 * long_pi);
  return stiffness / 2 * difference * difference;
}

Eigen::VectorXd Textbook::gradient(const Points& x) const {
  const long double step = 1e-6L;
  Eigen::VectorXd gradient(x.size());
  LongPoints moved = x.cast<long double>();
  for (int i = 0; i < x.size(); ++i) {
    long double& coordinate = moved.reshaped()(i);
    const long double middle = coordinate;
    coordinate = middle + step;
    const long double above = value(moved);
    coordinate = middle - step;
    gradient(i) = static_cast<double>((above - value(moved)) / (2 * step));
    coordinate = middle;
  }
  return gradient;
}

std::unique_ptr<Energy> make_twin(const std::string& name, const std::string& filter) {
  const Filter chosen = filter == "exact"   ? Filter::exact
                        : filter == "clamp" ? Filter::clamp
                                            : Filter::tight;
  const auto make = [&](auto kernel) -> std::unique_ptr<Energy> {
    return std::make_unique<BatchEnergy<decltype(kernel)>>(kernel, chosen, Evaluation::lanes);
  };
  if (name == "stretch") return make(StretchTwin{});
  if (name == "bending") return make(BendingTwin<AngleMeasure>{});
  if (name == "tan_bending") return make(BendingTwin<TangentMeasure>{});
  if (name == "sin_bending") return make(BendingTwin<SineMeasure>{});
  return make(TwistTwin{});
}

}  // namespace ringlet::test
