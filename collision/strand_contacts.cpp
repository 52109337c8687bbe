#include "collision/strand_contacts.h"

#include <algorithm>
#include <iterator>

#include "collision/segment_distance.h"
#include "core/registry.h"

namespace ringlet {
namespace {

/// Candidate pairs that are looked at together.
constexpr int pairs_a_part = 128;
/// Of the vertices, if no more than one in so many has moved far, only these are looked at.
constexpr std::size_t vertices_a_moved_one = 16;

SegmentGap gap_of(const EdgePair& pair, const VertexField& x) {
  return segment_gap(
      {x.get(pair.first), x.get(pair.first + 1), x.get(pair.second), x.get(pair.second + 1)});
}

}  // namespace

StrandContacts::StrandContacts(const Strands& strands, std::unique_ptr<ContactDetector> detector,
                               const ContactEnergy& response, const Parameters& parameters)
    : parameters_(parameters),
      strands_(strands),
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
  movement_.start_from(positions);
  limit_thickness();
}

// Candidates are the pairs nearer than the thickness and the margin where their vertices started.
// What has used half of what it may move starts anew here.
bool StrandContacts::detect_moved(std::span<const Eigen::Vector3d> from,
                                  std::span<const Eigen::Vector3d> to) {
  if (!movement_.has_started()) {
    detect(from);
    return true;
  }
  const Eigen::Isometry3d common = movement_.rigid_part(to);
  const double far = parameters_.margin / 4;
  std::vector<int> moved = movement_.beyond(far, to, common);
  if (from.data() != to.data()) {
    const std::vector<int> at_start = movement_.beyond(far, from, common);
    std::vector<int> all;
    std::set_union(moved.begin(), moved.end(), at_start.begin(), at_start.end(),
                   std::back_inserter(all));
    moved = std::move(all);
  }
  if (moved.size() * vertices_a_moved_one > from.size()) {
    detect(from);
    return true;
  }
  movement_.restart(moved, from, common);
  const std::vector<EdgePair> added = replace_pairs_with(edges_of(moved));
  limit_thickness();
  return std::any_of(added.begin(), added.end(), [&](const EdgePair& pair) {
    return is_nearer(from, pair, parameters_.thickness);
  });
}

/// Sorted, as the vertices are.
std::vector<int> StrandContacts::edges_of(std::span<const int> vertices) const {
  std::vector<int> edges;
  for (const int v : vertices) {
    const int first = strands_.first(strands_.strand_of(v));
    const int last = first + strands_.size(strands_.strand_of(v)) - 1;
    if (v > first && (edges.empty() || edges.back() < v - 1)) edges.push_back(v - 1);
    if (v < last) edges.push_back(v);
  }
  return edges;
}

/// Returns those that were none before.
std::vector<EdgePair> StrandContacts::replace_pairs_with(std::span<const int> edges) {
  naming(*detector_, [&] {
    detector_->find_with(edges, movement_.start(), parameters_.thickness + parameters_.margin,
                         found_);
  });
  std::erase_if(found_, [&](const EdgePair& pair) { return !rule_.allows(pair); });
  std::vector<char> has_moved(strands_.vertex_count());
  for (const int edge : edges) has_moved[edge] = 1;
  kept_.clear();
  std::vector<EdgePair> replaced, added;
  std::partition_copy(pairs_.begin(), pairs_.end(), std::back_inserter(replaced),
                      std::back_inserter(kept_), [&](const EdgePair& pair) {
                        return has_moved[pair.first] != 0 || has_moved[pair.second] != 0;
                      });
  pairs_.clear();
  std::merge(kept_.begin(), kept_.end(), found_.begin(), found_.end(), std::back_inserter(pairs_));
  std::set_difference(found_.begin(), found_.end(), replaced.begin(), replaced.end(),
                      std::back_inserter(added));
  return added;
}

void StrandContacts::detect_on_way(std::span<const Eigen::Vector3d> from,
                                   std::span<const Eigen::Vector3d> to, double reach) {
  pairs_ = continuous_->find(from, to, reach);
  movement_ = {};
  limit_thickness();
}

// Two edges come nearer to each other by no more than twice what a vertex moves.
bool StrandContacts::are_valid(std::span<const Eigen::Vector3d> from,
                               std::span<const Eigen::Vector3d> to, double reach) const {
  if (!movement_.has_started()) return false;
  const double allowed = (parameters_.thickness + parameters_.margin - reach) / 2;
  const Eigen::Isometry3d common = movement_.rigid_part(to);
  return movement_.is_within(allowed, to, common) &&
         (from.data() == to.data() || movement_.is_within(allowed, from, common));
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
  return bytes_of(pairs_) + bytes_of(thickness_) + bytes_of(found_) + bytes_of(kept_) +
         movement_.start().size_bytes() + detector_->bytes() +
         (rest_pairs_ ? rest_pairs_->bytes() : 0) + (continuous_ ? continuous_->bytes() : 0);
}

}  // namespace ringlet
