#pragma once

#include <memory>
#include <optional>

#include "collision/contact_rule.h"
#include "collision/continuous_detection.h"
#include "collision/movement.h"
#include "collision/rest_pairs.h"
#include "collision/touching.h"

namespace ringlet {

/// Strands against each other and themselves: pairs of edges.
class StrandContacts {
 public:
  struct Parameters {
    double thickness, stiffness, margin, arc_distance;
    std::optional<double> rest_slack;  ///< absent: pairs push at rest too
    bool with_ways;  ///< whether detect_on_way() or continuous() will be asked for
  };
  /// The strands and the response outlive this.
  StrandContacts(const Strands& strands, std::unique_ptr<ContactDetector> detector,
                 const ContactEnergy& response, const Parameters& parameters);
  StrandContacts(const StrandContacts&) = delete;
  StrandContacts& operator=(const StrandContacts&) = delete;

  void set_free(const std::vector<bool>& is_free) { rule_.set_free(is_free); }

  /// Collects the pairs nearer than the thickness and the margin as candidates.
  void detect(std::span<const Eigen::Vector3d> positions);
  /// The same where candidates have become invalid, for a way from some positions to others: if few
  /// vertices have moved far, only around them. Returns whether contacts that evaluate() found at
  /// the first positions may not be all.
  bool detect_moved(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to);
  /// Collects those that come nearer than reach, m, as all vertices move along straight lines; they
  /// are valid for that alone.
  void detect_on_way(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
                     double reach);
  /// Whether all pairs that come nearer than reach on a way are candidates.
  bool are_valid(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
                 double reach) const;
  /// The part of a way along which a part of the gap of each candidate is left; see
  /// free_part_of_pairs().
  double free_part(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
                   double kept_part) const;
  /// Contacts of the candidates that touch.
  void evaluate(const VertexField& x, Touching& touching) const;

  std::size_t bytes() const;

  ContinuousDetection* continuous() { return continuous_ ? &*continuous_ : nullptr; }

 private:
  std::vector<int> edges_of(std::span<const int> vertices) const;
  std::vector<EdgePair> replace_pairs_with(std::span<const int> edges);
  void limit_thickness();
  double stiffness_of(int pair) const;
  /// Of count candidate pairs from the first on, no more than there are lanes.
  void add_touching(int first, int count, const VertexField& x,
                    std::vector<Touching::Found>& found) const;

  Parameters parameters_;
  const Strands& strands_;
  const ContactEnergy& response_;
  ContactRule rule_;
  std::unique_ptr<ContactDetector> detector_;
  std::optional<RestPairs> rest_pairs_;
  std::optional<ContinuousDetection> continuous_;
  Movement movement_;                   // since candidates were collected
  std::vector<EdgePair> pairs_;         // candidates
  std::vector<double> thickness_;       // of each
  std::vector<EdgePair> found_, kept_;  // for the memory alone
};

}  // namespace ringlet
