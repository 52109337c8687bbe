#pragma once

#include <string>

#include "tests/energies/make.h"

namespace ringlet::test {

inline const std::string elastic_names[] = {"stretch", "bending", "tan_bending", "sin_bending",
                                            "twist"};
inline int vertices_of(const std::string& name) {
  return name == "stretch" ? 2 : name == "twist" ? 4 : 3;
}

/// The energies again, from other formulas than the kernels', in long double.
struct Textbook {
  std::string name;       ///< of an energy
  long double stiffness;  ///< k
  long double rest;       ///< length, angle or curvature

  /// Stiffness and rest value from a rest shape.
  Textbook(const std::string& energy, const Points& rest_shape, const Material& material);

  long double measure(const Eigen::Matrix<long double, 3, Eigen::Dynamic>& x) const;
  long double value(const Eigen::Matrix<long double, 3, Eigen::Dynamic>& x) const;
  /// Central differences of value().
  Eigen::VectorXd gradient(const Points& x) const;
};

/// An energy that only has a value, so that its derivatives are found by automatic differentiation.
std::unique_ptr<Energy> make_twin(const std::string& name, const std::string& filter);

}  // namespace ringlet::test
