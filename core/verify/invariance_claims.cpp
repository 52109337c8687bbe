#include <Eigen/Geometry>

#include "core/verify/subject.h"

namespace ringlet {

namespace {

constexpr double allowed_of_motions = 1e-9;

struct InvarianceClaims {
  Claim translation{"translations change nothing", allowed_of_motions};
  Claim far_away{"far from the origin nothing changes", allowed_of_motions};
  Claim rotation{"rotations turn gradient and Hessian", allowed_of_motions};
  Claim forces{"forces and their moments add up to zero", allowed_of_motions};
  Claim rest{"at rest there is no force", allowed_of_motions};
};

/// The largest relative error of anything of the probe, of which value and gradient may be small.
double difference(const Probe& a, const Probe& b, double edge) {
  const double gradient = b.gradient.cwiseAbs().maxCoeff();
  const double value = std::abs(a.value - b.value) / std::max(std::abs(b.value), gradient * edge);
  return std::max({value, relative_difference(a.gradient, b.gradient, std::abs(b.value) / edge),
                   relative_difference(a.hessian, b.hessian, gradient / edge)});
}

/// Multiples of 2^-40, so that adding 1024 to them is exact.
Points rounded(const Points& x) {
  constexpr double unit = 0x1p-40;
  return (x / unit).array().round().matrix() * unit;
}

Probe turned(const Probe& probe, const Eigen::Matrix3d& rotation) {
  Probe result = probe;
  const auto vertices = probe.gradient.size() / 3;
  Eigen::MatrixXd turn = Eigen::MatrixXd::Zero(3 * vertices, 3 * vertices);
  for (int v = 0; v < vertices; ++v) turn.block<3, 3>(3 * v, 3 * v) = rotation;
  result.gradient = turn * probe.gradient;
  result.hessian = turn * probe.hessian * turn.transpose();
  return result;
}

double resultant(const Probe& probe, const VerifyState& state) {
  const Points forces = probe.gradient.reshaped(3, state.x.cols());
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (int v = 0; v < state.x.cols(); ++v) {
    const Eigen::Vector3d arm = state.x.col(v) - state.x.col(0), force = forces.col(v);
    moment += arm.cross(force);
  }
  const double largest = forces.cwiseAbs().maxCoeff();
  if (largest == 0) return 0;
  return std::max(forces.rowwise().sum().norm() / largest,
                  moment.norm() / (largest * (state.x.colwise() - state.x.col(0)).norm()));
}

void see(const Subject& subject, const VerifyState& state, std::mt19937_64& random,
         InvarianceClaims& claims) {
  const BoundEnergy energy = subject.bound("", state);
  const Probe probe = energy.at(state.x);
  const double edge = state.edge();
  const Eigen::Vector3d shift = edge * random_points(random, 1);
  claims.translation.see(difference(energy.at(state.x.colwise() + shift), probe, edge), state.name);
  const Eigen::Matrix3d rotation = random_rotation(random);
  claims.rotation.see(difference(energy.at(rotation * state.x), turned(probe, rotation), edge),
                      state.name);
  claims.forces.see(resultant(probe, state), state.name);
  const Eigen::VectorXd at_rest = energy.at(state.rest).gradient;
  claims.rest.see(relative_difference(at_rest, 0 * at_rest, probe.gradient.cwiseAbs().maxCoeff()),
                  state.name);
  const Points here = rounded(state.x);
  const BoundEnergy bound_here(subject.energy(""), rounded(state.rest));
  claims.far_away.see(difference(bound_here.at(here.array() + 1024), bound_here.at(here), edge),
                      state.name);
}

}  // namespace

void claim_invariance(const Subject& subject, std::vector<Claim>& claims) {
  InvarianceClaims own;
  std::mt19937_64 random(subject.seed);
  for (const VerifyState& state : subject.states) see(subject, state, random, own);
  for (Claim* claim : {&own.translation, &own.far_away, &own.rotation, &own.forces, &own.rest}) {
    claims.push_back(std::move(*claim));
  }
}

}  // namespace ringlet
