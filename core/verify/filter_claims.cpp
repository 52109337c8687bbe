#include <Eigen/Eigenvalues>

#include "core/verify/subject.h"

namespace ringlet {

namespace {

constexpr double rounding = 1e-9;

/// What a filter claims; every filter is positive semi-definite, but for `exact`.
struct FilterClaims {
  std::string filter;
  Claim semidefinite{filter + ": positive semi-definite", rounding};
  Claim majorant{filter + ": nowhere below the exact Hessian", rounding};
  Claim rest{filter + ": the exact Hessian at rest", rounding};
  Claim numeric{filter + ": that of the eigenvalues of an element", rounding};

  bool is_numeric() const { return filter == "clamp" || filter == "absolute"; }
  bool is_majorant() const { return filter != "gauss_newton"; }
};

Eigen::MatrixXd filter_densely(const Eigen::MatrixXd& exact, bool absolute) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(exact);
  const Eigen::VectorXd eigenvalues =
      absolute ? solver.eigenvalues().cwiseAbs().eval() : solver.eigenvalues().cwiseMax(0).eval();
  return solver.eigenvectors() * eigenvalues.asDiagonal() * solver.eigenvectors().transpose();
}

void see(const Subject& subject, const VerifyState& state, FilterClaims& claims) {
  const BoundEnergy energy = subject.bound(claims.filter, state);
  const Eigen::MatrixXd filtered = energy.at(state.x).hessian;
  claims.semidefinite.see(negative_part(filtered, largest_entry(filtered)), state.name);
  if (!subject.has_filter("exact")) return;
  const BoundEnergy unfiltered = subject.bound("exact", state);
  const Eigen::MatrixXd exact = unfiltered.at(state.x).hessian;
  claims.majorant.see(
      negative_part(filtered - exact, std::max(largest_entry(filtered), largest_entry(exact))),
      state.name);
  claims.rest.see(
      relative_difference(energy.at(state.rest).hessian, unfiltered.at(state.rest).hessian, 0),
      state.name);
  if (claims.is_numeric() && state.x.cols() == subject.vertices) {
    const Eigen::MatrixXd expected = filter_densely(exact, claims.filter == "absolute");
    claims.numeric.see(relative_difference(filtered, expected, largest_entry(exact)), state.name);
  }
}

}  // namespace

void claim_filters(const Subject& subject, std::vector<Claim>& claims) {
  for (const std::string& filter : subject.variants()) {
    if (filter == "exact") continue;
    FilterClaims own{filter};
    for (const VerifyState& state : subject.states) see(subject, state, own);
    for (const VerifyState& state : subject.near_states) see(subject, state, own);
    claims.push_back(std::move(own.semidefinite));
    if (!subject.has_filter("exact")) continue;
    if (own.is_majorant()) claims.push_back(std::move(own.majorant));
    claims.push_back(std::move(own.rest));
    if (own.is_numeric()) claims.push_back(std::move(own.numeric));
  }
}

}  // namespace ringlet
