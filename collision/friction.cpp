#include "collision/friction.h"

namespace ringlet {
namespace {

Eigen::Vector3d weighted_sum(const std::array<int, 4>& vertices,
                             const std::array<double, 4>& weights, const VertexField& x) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = 0; i < 4; ++i) {
    if (weights[i] != 0) sum += weights[i] * x.get(vertices[i]);
  }
  return sum;
}

/// f and its derivatives at a distance y.
struct Smoothed {
  double value;
  double slope_over_distance;  ///< f'(y) / y
  double curvature;            ///< f''(y)
};

Smoothed smoothed_distance(double y, double e) {
  if (y >= e) return {y, 1 / y, 0};
  const double ratio = y / e;
  return {e / 3 + y * ratio * (1 - ratio / 3), (2 - ratio) / e, 2 * (1 - ratio) / e};
}

}  // namespace

void Friction::begin_step(const VertexField& x_n, double dt) {
  x_n_ = x_n;
  sticking_distance_ = sticking_speed_ * dt;
}

void Friction::add_strand_contact(const Contact& contact) {
  add_contact(contact, strand_coefficient_, Eigen::Vector3d::Zero());
}

void Friction::add_collider_contact(const Contact& contact,
                                    const Eigen::Vector3d& collider_displacement) {
  add_contact(contact, collider_coefficient_, collider_displacement);
}

void Friction::add_contact(const Contact& contact, double coefficient,
                           const Eigen::Vector3d& displacement) {
  const double limit = -coefficient * contact.energy.slope;
  if (!(limit > 0)) return;
  sliding_.push_back({contact.vertices, contact.weights, contact.normal, limit,
                      weighted_sum(contact.vertices, contact.weights, x_n_) + displacement});
}

double Friction::add(const VertexField& x, Couplings* couplings) const {
  double energy = 0;
  for (const Sliding& contact : sliding_) {
    const Eigen::Matrix3d tangential =
        Eigen::Matrix3d::Identity() - contact.normal * contact.normal.transpose();
    const Eigen::Vector3d slid =
        tangential * (weighted_sum(contact.vertices, contact.weights, x) - contact.start);
    const double distance = slid.norm();
    const Smoothed f = smoothed_distance(distance, sticking_distance_);
    energy += contact.limit * f.value;
    if (couplings == nullptr) continue;
    Eigen::Matrix3d curvature = f.slope_over_distance * tangential;
    if (distance > 0) {
      const Eigen::Vector3d along = slid / distance;
      curvature += (f.curvature - f.slope_over_distance) * along * along.transpose();
    }
    couplings->add(CouplingTerm{contact.vertices, contact.weights,
                                contact.limit * f.slope_over_distance * slid,
                                contact.limit * curvature});
  }
  return energy;
}

}  // namespace ringlet
