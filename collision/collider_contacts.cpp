#include "collision/collider_contacts.h"

#include <algorithm>

#include "collision/continuous.h"
#include "core/parallel.h"
#include "core/registry.h"

namespace ringlet {
namespace {

void ask(const Collider& collider, std::span<const Eigen::Vector3d> points, double reach,
         std::span<std::optional<Proximity>> found) {
  naming(collider, [&] { collider.near(points, reach, found); });
}

/// The proximities of no more points than a chunk has vertices, in a collider's own frame.
struct Neighbourhood {
  std::array<Eigen::Vector3d, chunk_edges + 1> points;
  std::array<std::optional<Proximity>, chunk_edges + 1> found;

  void find(const Collider& collider, int count, double reach) {
    found.fill(std::nullopt);
    ask(collider, std::span(points).first(count), reach, std::span(found).first(count));
  }
};

}  // namespace

void ColliderContacts::bind(const std::vector<EdgeChunk>& chunks, const Motions& motions) {
  chunks_ = &chunks;
  motions_ = &motions;
  move_to(0, 0);
}

void ColliderContacts::move_to(double time_end, double dt) {
  placements_.clear();
  since_begin_.clear();
  for (const auto& collider : colliders_) {
    const std::string& motion = collider->placement().motion.name;
    placements_.push_back(motions_->at(motion, time_end));
    since_begin_.push_back(placements_.back() * motions_->at(motion, time_end - dt).inverse());
  }
}

double ColliderContacts::free_part(int collider, const Eigen::Vector3d& from,
                                   const Eigen::Vector3d& to, const KeptGap& kept) const {
  const Eigen::Isometry3d to_collider = placements_[collider].inverse();
  const double longest = (to - from).norm();
  if (longest == 0) return 1;
  const double far = 2 * longest;  // enough to go all the way
  return ringlet::free_part(longest, kept, [&](double part) {
    const Eigen::Vector3d point = to_collider * (from + part * (to - from));
    std::optional<Proximity> found;
    ask(*colliders_[collider], {&point, 1}, far, {&found, 1});
    return found ? found->distance : far;
  });
}

double ColliderContacts::free_part(std::span<const Eigen::Vector3d> from,
                                   std::span<const Eigen::Vector3d> to, const KeptGap& kept) const {
  std::vector<double> parts(vertices_.size() + 1, 1);
  parallel_for_each(candidate_count(), [&](int n) {
    const int v = vertices_[n];
    parts[n] = free_part(collider_of_[n], from[v], to[v], kept);
  });
  return *std::min_element(parts.begin(), parts.end());
}

void ColliderContacts::carry_what_is_hit(std::span<const Eigen::Vector3d> start,
                                         std::span<Eigen::Vector3d> to) const {
  for (int c = 0; c < static_cast<int>(colliders_.size()); ++c) {
    const std::vector<int> reachable = find_reachable(c, start, to);
    parallel_for_each(static_cast<int>(reachable.size()), [&](int n) {
      const int v = reachable[n];
      const Eigen::Vector3d carried = since_begin_[c] * start[v];
      if (free_part(c, carried, to[v], {vanishing}) < 1) to[v] = carried;
    });
  }
}

double ColliderContacts::free_part_of_step(std::span<const Eigen::Vector3d> start,
                                           std::span<const Eigen::Vector3d> to,
                                           const KeptGap& kept) const {
  double least = 1;
  for (int c = 0; c < static_cast<int>(colliders_.size()); ++c) {
    const std::vector<int> reachable = find_reachable(c, start, to);
    std::vector<double> parts(reachable.size() + 1, 1);
    parallel_for_each(static_cast<int>(reachable.size()), [&](int n) {
      const int v = reachable[n];
      parts[n] = free_part(c, since_begin_[c] * start[v], to[v], kept);
    });
    least = std::min(least, *std::min_element(parts.begin(), parts.end()));
  }
  return least;
}

// The free vertices that may meet a collider in a step: if none has used up the margin, candidates.
std::vector<int> ColliderContacts::find_reachable(int collider,
                                                  std::span<const Eigen::Vector3d> start,
                                                  std::span<const Eigen::Vector3d> to) const {
  std::vector<int> reachable;
  if (movement_.has_started()) {
    const Eigen::Isometry3d motion = placements_[collider] * detected_[collider].inverse();
    if (movement_.is_within(margin_, to, motion) &&
        movement_.is_within(margin_, start, since_begin_[collider].inverse() * motion)) {
      for (int n = 0; n < candidate_count(); ++n) {
        if (collider_of_[n] == collider) reachable.push_back(vertices_[n]);
      }
      return reachable;
    }
  }
  for (int v = 0; v < static_cast<int>(start.size()); ++v) {
    if (is_free_[v]) reachable.push_back(v);
  }
  return reachable;
}

double ColliderContacts::deepest(std::span<const Eigen::Vector3d> positions) const {
  std::vector<double> depths(positions.size(), 0.0);
  for (std::size_t c = 0; c < colliders_.size(); ++c) {
    const Eigen::Isometry3d to_collider = placements_[c].inverse();
    parallel_for_each(static_cast<int>(positions.size()), [&](int v) {
      if (!is_free_[v]) return;
      const Eigen::Vector3d point = to_collider * positions[v];
      std::optional<Proximity> found;
      ask(*colliders_[c], {&point, 1}, 0, {&found, 1});
      if (found) depths[v] = std::max(depths[v], -found->distance);
    });
  }
  return depths.empty() ? 0 : *std::max_element(depths.begin(), depths.end());
}

Eigen::Vector3d ColliderContacts::displacement(int candidate, const Eigen::Vector3d& point) const {
  return point - since_begin_[collider_of_[candidate]].inverse() * point;
}

std::vector<Pin> ColliderContacts::pins(std::span<const Eigen::Vector3d> positions) const {
  std::vector<Pin> pins;
  for (int c = 0; c < static_cast<int>(colliders_.size()); ++c) {
    const ColliderPlacement& placement = colliders_[c]->placement();
    if (!placement.pins) continue;
    std::vector<int> inside;
    for (const EdgeChunk& chunk : *chunks_) {
      find_near(c, chunk, false, positions, 0, inside);
      for (const int vertex : inside) pins.push_back({vertex, placement.motion.name});
    }
  }
  return pins;
}

void ColliderContacts::find_near(int collider, const EdgeChunk& chunk, bool free_only,
                                 std::span<const Eigen::Vector3d> positions, double reach,
                                 std::vector<int>& vertices) const {
  const Eigen::Isometry3d to_collider = placements_[collider].inverse();
  Neighbourhood neighbourhood;
  vertices.clear();
  for (int v = chunk.first; v < chunk.first + chunk.vertices; ++v) {
    if (free_only && !is_free_[v]) continue;
    neighbourhood.points[vertices.size()] = to_collider * positions[v];
    vertices.push_back(v);
  }
  const int count = static_cast<int>(vertices.size());
  if (count == 0) return;
  neighbourhood.find(*colliders_[collider], count, reach);
  int kept = 0;
  for (int n = 0; n < count; ++n) {
    const auto& found = neighbourhood.found[n];
    if (found && found->distance < reach) vertices[kept++] = vertices[n];
  }
  vertices.resize(kept);
}

// A distance to a collider changes by no more than the vertex moves in the collider's frame.
bool ColliderContacts::are_valid(std::span<const Eigen::Vector3d> positions) const {
  if (!colliders_.empty() && !movement_.has_started()) return false;
  for (std::size_t c = 0; c < colliders_.size(); ++c) {
    const Eigen::Isometry3d motion = placements_[c] * detected_[c].inverse();
    if (!movement_.is_within(margin_, positions, motion)) return false;
  }
  return true;
}

void ColliderContacts::detect(std::span<const Eigen::Vector3d> positions) {
  collect(positions, margin_);
  if (!colliders_.empty()) movement_.start_from(positions);
}

void ColliderContacts::detect_on_way(std::span<const Eigen::Vector3d> positions, double margin) {
  collect(positions, margin);
  movement_ = {};
}

void ColliderContacts::collect(std::span<const Eigen::Vector3d> positions, double margin) {
  detected_ = placements_;
  vertices_.clear();
  collider_of_.clear();
  batches_.clear();
  near_.resize(chunks_->size());
  for (int c = 0; c < static_cast<int>(colliders_.size()); ++c) {
    parallel_for_each(static_cast<int>(chunks_->size()), [&](int n) {
      find_near(c, (*chunks_)[n], true, positions, law_.thickness + margin, near_[n]);
    });
    for (const std::vector<int>& part : near_) {
      if (part.empty()) continue;
      const int begin = candidate_count();
      vertices_.insert(vertices_.end(), part.begin(), part.end());
      collider_of_.resize(vertices_.size(), c);
      batches_.push_back({c, begin, candidate_count()});
    }
  }
}

void ColliderContacts::evaluate(const VertexField& x, Touching& touching) const {
  touching.collect(static_cast<int>(batches_.size()),
                   [&](int b, auto& found) { evaluate_batch(batches_[b], x, found); });
}

void ColliderContacts::evaluate_batch(const Batch& batch, const VertexField& x,
                                      std::vector<Touching::Found>& touching) const {
  const Eigen::Isometry3d& placement = placements_[batch.collider];
  const Eigen::Isometry3d to_collider = placement.inverse();
  Neighbourhood neighbourhood;
  const int count = batch.end - batch.begin;
  for (int n = 0; n < count; ++n) {
    neighbourhood.points[n] = to_collider * x.get(vertices_[batch.begin + n]);
  }
  neighbourhood.find(*colliders_[batch.collider], count, law_.thickness);
  const auto evaluate_law = [&](double distance) {
    return naming(*law_.energy, [&] { return law_.at(distance); });
  };
  for (int n = 0; n < count; ++n) {
    const auto& found = neighbourhood.found[n];
    if (!found || !(found->distance < law_.thickness)) continue;
    const int vertex = vertices_[batch.begin + n];
    touching.push_back({batch.begin + n,
                        {{vertex, vertex, vertex, vertex},
                         {1, 0, 0, 0},
                         placement.linear() * found->normal,
                         law_.thickness - found->distance,
                         evaluate_law(found->distance)}});
  }
}

std::size_t ColliderContacts::bytes() const {
  std::size_t sum = bytes_of(near_) + bytes_of(vertices_) + bytes_of(collider_of_) +
                    bytes_of(batches_) + movement_.start().size_bytes();
  for (const auto& collider : colliders_) sum += collider->bytes();
  return sum;
}

}  // namespace ringlet
