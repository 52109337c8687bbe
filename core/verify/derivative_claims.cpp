#include "core/verify/differences.h"
#include "core/verify/subject.h"

namespace ringlet {

namespace {

// What can be expected of differences, and the first step relative to an edge.
constexpr double allowed_by_differences = 1e-6, first_step = 1e-2;

struct DerivativeClaims {
  Claim zero{"value, gradient and Hessian are not zero", 0};
  Claim value{"the value is the same without derivatives", 1e-12};
  Claim gradient{"the gradient is the derivative of the value", allowed_by_differences};
  Claim hessian{"the Hessian is the derivative of the gradient", allowed_by_differences};
};

void see_hessian(const Subject& subject, const VerifyState& state, const BoundEnergy& energy,
                 const Probe& probe, Claim& claim) {
  const Eigen::MatrixXd expected = differences(
      [&](const Points& x) { return energy.at(x).gradient; }, state.x, first_step * state.edge());
  const double least = 1e-3 * probe.gradient.cwiseAbs().maxCoeff() / state.edge();
  if (subject.has_filter("exact")) {
    claim.see(relative_difference(probe.hessian, expected, least), state.name);
  } else {
    // A Hessian that cannot be had unfiltered must not be below the exact one.
    const Eigen::MatrixXd above = probe.hessian - 0.5 * (expected + expected.transpose());
    const double scale = std::max(expected.cwiseAbs().maxCoeff(), least);
    claim.see(std::max(0.0, -smallest_eigenvalue(above)) / scale, state.name);
  }
}

void see(const Subject& subject, const VerifyState& state, DerivativeClaims& claims) {
  const BoundEnergy energy = subject.bound(subject.has_filter("exact") ? "exact" : "", state);
  const Probe probe = energy.at(state.x);
  const bool is_zero = probe.value == 0 || probe.gradient.isZero(0) || probe.hessian.isZero(0);
  claims.zero.see(is_zero ? 1 : 0, state.name);
  claims.value.see(std::abs(energy.value(state.x) - probe.value) / std::abs(probe.value),
                   state.name);
  const double least = 1e-3 * std::abs(probe.value) / state.edge();
  const Eigen::MatrixXd gradient =
      differences([&](const Points& x) { return Eigen::VectorXd::Constant(1, energy.value(x)); },
                  state.x, first_step * state.edge());
  claims.gradient.see(relative_difference(probe.gradient.transpose(), gradient, least), state.name);
  see_hessian(subject, state, energy, probe, claims.hessian);
}

}  // namespace

void claim_derivatives(const Subject& subject, std::vector<Claim>& claims) {
  DerivativeClaims own;
  if (!subject.has_filter("exact")) own.hessian.text = "the Hessian is not below the exact one";
  for (const VerifyState& state : subject.states) see(subject, state, own);
  for (Claim* claim : {&own.zero, &own.value, &own.gradient, &own.hessian}) {
    claims.push_back(std::move(*claim));
  }
}

}  // namespace ringlet
