#include <random>

#include "core/verify/subject.h"

namespace ringlet {

namespace {

constexpr double allowed_of_holds = 1e-7;  // a nearly folded hinge keeps few digits of a small load

struct HoldingClaims {
  Claim proportion{"elements that hold a load pull in proportion to it", allowed_of_holds};
  Claim direction{"and in the direction of their own force", allowed_of_holds};
};

/// How far a is from a multiple of b, relative to a.
double not_along(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  const Eigen::VectorXd across = a - a.dot(b) / b.squaredNorm() * b;
  return across.norm() / a.norm();
}

/// Returns false if the energy has no elements that hold anything.
bool see(const Subject& subject, const VerifyState& state, std::mt19937_64& random,
         HoldingClaims& claims) {
  const Strands strands({static_cast<int>(state.rest.cols())}, columns(state.rest),
                        plain_material());
  const StrandGroups groups(strands);
  const std::unique_ptr<Energy> energy = subject.energy("");
  energy->bind(strands, groups);
  HoldingElements* elements = energy->holding_elements();
  if (elements == nullptr) return false;
  std::uniform_real_distribution<double> slopes(0.05, 0.2);
  for (int first = 0; first + elements->vertices() <= state.x.cols(); ++first) {
    const Points x = state.x.middleCols(first, elements->vertices());
    const auto pull = [&](double slope) {
      elements->hold(first, x, slope);
      return elements->derivatives(first, x).gradient;
    };
    const Eigen::VectorXd own = elements->derivatives(first, x).gradient;
    const double slope = slopes(random), other = -slopes(random);
    if (own.norm() == 0 || elements->hold(first, x, slope) == Hold::impossible) continue;
    const Eigen::VectorXd held = pull(slope);
    claims.proportion.see((pull(other) - other / slope * held).norm() / held.norm(), state.name);
    claims.proportion.see(pull(0).norm() / held.norm(), state.name);
    claims.direction.see(not_along(own, held), state.name);
  }
  return true;
}

}  // namespace

void claim_holding(const Subject& subject, std::vector<Claim>& claims) {
  HoldingClaims own;
  std::mt19937_64 random(subject.seed);
  for (const VerifyState& state : subject.states) {
    if (!see(subject, state, random, own)) return;
  }
  claims.push_back(std::move(own.proportion));
  claims.push_back(std::move(own.direction));
}

}  // namespace ringlet
