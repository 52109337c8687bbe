#pragma once

#include <vector>

#include "collision/contact.h"

namespace ringlet {

/// Coulomb's friction of contacts, smoothed and lagged as in "Incremental Potential Contact" (Li et
/// al., SIGGRAPH 2020, section 5). With the coefficient mu, the force N, the normal n and the
/// weights w_i of a contact, all as they were when it was last looked at,
///
///     D(x) = mu N f(|u|),   u = (I - n n^T) (sum_i w_i x_i - s)
///
/// is the energy of what slides by u within a step; s is the sum where nothing has slid. It is
/// f'(y) = 1 for y > e, else 2 y/e - (y/e)^2, e being the sticking speed times dt: what should
/// stick creeps at less than the sticking speed. The Hessian in the tangent plane has the
/// eigenvalues mu N f''(|u|) >= 0 and mu N f'(|u|)/|u| >= 0.
class Friction {
 public:
  /// Contacts of edges and of colliders have coefficients of their own; speed in m/s.
  Friction(double strand_coefficient, double collider_coefficient, double sticking_speed)
      : strand_coefficient_(strand_coefficient),
        collider_coefficient_(collider_coefficient),
        sticking_speed_(sticking_speed) {}

  bool is_wanted() const { return strand_coefficient_ > 0 || collider_coefficient_ > 0; }
  void begin_step(const VertexField& x_n, double dt);
  void clear() { sliding_.clear(); }
  /// Two edges touch.
  void add_strand_contact(const Contact& contact);
  /// A vertex touches a collider, of which the touched point was elsewhere as the step began, by so
  /// much.
  void add_collider_contact(const Contact& contact, const Eigen::Vector3d& collider_displacement);

  /// Returns the energy at x; adds its terms unless null.
  double add(const VertexField& x, Couplings* couplings) const;

 private:
  struct Sliding {
    std::array<int, 4> vertices;
    std::array<double, 4> weights;
    Eigen::Vector3d normal;
    double limit;           // mu N, N
    Eigen::Vector3d start;  // s, m
  };
  void add_contact(const Contact& contact, double coefficient, const Eigen::Vector3d& displacement);

  double strand_coefficient_, collider_coefficient_, sticking_speed_;
  double sticking_distance_ = 0;  // of a step
  VertexField x_n_;
  std::vector<Sliding> sliding_;
};

}  // namespace ringlet
