#pragma once

#include "core/verify/shapes.h"
#include "core/verify/verify_energy.h"

namespace ringlet {

/// A strand, deformed.
struct VerifyState {
  std::string name;
  Points rest, x;

  double edge() const { return (x.col(1) - x.col(0)).norm(); }
};

/// An energy that is to be verified, and the states to do so.
struct Subject {
  EnergyMaker make;
  std::uint64_t seed;
  int vertices;                          ///< of its smallest strand, which holds one element
  std::vector<std::string> filters;      ///< that it offers; none: it has no such key
  std::vector<VerifyState> states;       ///< where derivatives are smooth
  std::vector<VerifyState> near_states;  ///< close to where an angle has no derivative or no value

  /// Throws Error if the energy has no stiffness in any state.
  Subject(const EnergyMaker& make, const VerifyOptions& options);

  bool has_filter(const std::string& name) const;
  /// The filters; "" alone where it has no such key.
  std::vector<std::string> variants() const;
  /// With a filter and further keys; "" stands for the energy as it is by default.
  std::unique_ptr<Energy> energy(const std::string& filter, Json keys = Json::object()) const;
  BoundEnergy bound(const std::string& filter, const VerifyState& state) const;
};

/// The number of vertices of the smallest strand that has an element of an energy. Throws Error if
/// there is none.
int smallest_strand(const EnergyMaker& make, std::mt19937_64& random);

/// |a - b| relative to the larger of |b| and least, by their largest entries.
double relative_difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b, double least);

double largest_entry(const Eigen::MatrixXd& matrix);
/// How far the smallest eigenvalue is below zero, relative to the scale.
double negative_part(const Eigen::MatrixXd& matrix, double scale);

// Each appends its claims.
void claim_derivatives(const Subject& subject, std::vector<Claim>& claims);
void claim_invariance(const Subject& subject, std::vector<Claim>& claims);
void claim_filters(const Subject& subject, std::vector<Claim>& claims);
void claim_assembly(const Subject& subject, std::vector<Claim>& claims);
void claim_holding(const Subject& subject, std::vector<Claim>& claims);
void claim_degenerate(const Subject& subject, std::vector<Claim>& claims);

}  // namespace ringlet
