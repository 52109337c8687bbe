#include "collision/strand_contacts.h"

#include "core/registry.h"

namespace ringlet {
namespace {

/// Candidate pairs that are looked at together.
constexpr int pairs_a_part = 128;

SegmentGap gap_of(const EdgePair& pair, const VertexField& x) {
  return segment_gap(
      {x.get(pair.first), x.get(pair.first + 1), x.get(pair.second), x.get(pair.second + 1)});
}

}  // namespace

StrandContacts::StrandContacts(const Strands& strands, std::unique_ptr<ContactDetector> detector,
                               const ContactEnergy& response, const Parameters& parameters)
    : parameters_(parameters),
      response_(response),
      rule_(strands, parameters.arc_distance),
      detector_(std::move(detector)) {
  naming(*detector_, [&] { detector_->bind(strands); });
  if (parameters.rest_slack) {
    rest_pairs_.emplace(strands, *detector_, parameters.thickness, *parameters.rest_slack);
  }
  if (parameters.with_ways) continuous_.emplace(strands, rule_);
}

void StrandContacts::detect(std::span<const Eigen::Vector3d> positions) {
  naming(*detector_,
         [&] { detector_->find(positions, parameters_.thickness + parameters_.margin, pairs_); });
  std::erase_if(pairs_, [&](const EdgePair& pair) { return !rule_.allows(pair); });
  limit_thickness();
}

void StrandContacts::detect_on_way(std::span<const Eigen::Vector3d> from,
                                   std::span<const Eigen::Vector3d> to, double reach) {
  pairs_ = continuous_->find(from, to, reach);
  limit_thickness();
}

// Two edges come nearer to each other by no more than twice what a vertex moves.
bool StrandContacts::are_valid(std::span<const Eigen::Vector3d> from,
                               std::span<const Eigen::Vector3d> to, double reach,
                               const Movement& movement) const {
  const double allowed = (parameters_.thickness + parameters_.margin - reach) / 2;
  const Eigen::Isometry3d common = movement.rigid_part(to);
  return movement.is_within(allowed, to, common) &&
         (from.data() == to.data() || movement.is_within(allowed, from, common));
}

double StrandContacts::free_part(std::span<const Eigen::Vector3d> from,
                                 std::span<const Eigen::Vector3d> to, double kept_part) const {
  return free_part_of_pairs(pairs_, thickness_, from, to, kept_part);
}

void StrandContacts::limit_thickness() {
  thickness_.assign(pairs_.size(), parameters_.thickness);
  if (rest_pairs_) rest_pairs_->limit(pairs_, thickness_);
}

// A barrier pushes a pair that is near at rest, and so has a small thickness, with as large forces
// as any other: else loads would close its gap to nothing, where no step can go on.
double StrandContacts::stiffness_of(int p) const {
  if (!response_.is_barrier() || thickness_[p] == 0) return parameters_.stiffness;
  return parameters_.stiffness * parameters_.thickness / thickness_[p];
}

void StrandContacts::evaluate(const VertexField& x, Touching& touching) const {
  const int pairs = static_cast<int>(pairs_.size());
  touching.collect((pairs + pairs_a_part - 1) / pairs_a_part, [&](int part, auto& found) {
    const int end = std::min(pairs, (part + 1) * pairs_a_part);
    for (int p = part * pairs_a_part; p < end; p += lane_count) {
      add_touching(p, std::min(lane_count, end - p), x, found);
    }
  });
}

void StrandContacts::add_touching(int first, int count, const VertexField& x,
                                  std::vector<Touching::Found>& found) const {
  const std::span<const EdgePair> pairs(&pairs_[first], count);
  const SegmentGaps gaps(pairs, x, parameters_.thickness);
  const std::size_t found_before = found.size();
  for (int n = 0; n < count; ++n) {
    const EdgePair& pair = pairs[n];
    const double distance = gaps.distances()[n], thickness = thickness_[first + n];
    if (distance >= thickness) continue;
    const SegmentGap gap = distance == 0 ? gap_of(pair, x) : gaps.of(n);
    found.push_back({first + n,
                     {{pair.first, pair.first + 1, pair.second, pair.second + 1},
                      gap.weights,
                      gap.normal,
                      thickness - distance,
                      {}}});
  }
  if (found.size() == found_before) return;
  naming(response_, [&] {
    for (auto& [p, contact] : std::span(found).subspan(found_before)) {
      contact.energy = response_.at(gaps.distances()[p - first], thickness_[p], stiffness_of(p));
    }
  });
}

std::size_t StrandContacts::bytes() const {
  return bytes_of(pairs_) + bytes_of(thickness_) + detector_->bytes() +
         (rest_pairs_ ? rest_pairs_->bytes() : 0) + (continuous_ ? continuous_->bytes() : 0);
}

}  // namespace ringlet
