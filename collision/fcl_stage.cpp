// A collision stage on FCL's broad phase. The contact energy is a sum over all pairs of strand
// edges, and all vertices and colliders, of a function of their distance (see responses/); its
// thickness h is the distance at rest of two edges, where that is less.

#include "collision/fcl_stage.h"

#include "collision/continuous.h"
#include "core/parallel.h"

namespace ringlet {
namespace {

std::vector<std::unique_ptr<Collider>> make_all(const std::vector<Choice<Collider>>& choices) {
  std::vector<std::unique_ptr<Collider>> colliders;
  for (const auto& choice : choices) colliders.push_back(choice.make());
  return colliders;
}

/// Candidate pairs that are looked at together.
constexpr int pairs_a_part = 128;

SegmentGap gap_of(const EdgePair& pair, const VertexField& x) {
  return segment_gap(
      {x.get(pair.first), x.get(pair.first + 1), x.get(pair.second), x.get(pair.second + 1)});
}

/// What an iteration must leave of a gap within the thickness. Newton's method opens a small gap
/// that a barrier pushes apart to no more than twice its width in an iteration: if more of it got
/// lost as edges turn about each other, it would vanish, and all motion with it.
constexpr double kept_part = 0.5;

double longest_distance(std::span<const Eigen::Vector3d> from,
                        std::span<const Eigen::Vector3d> to) {
  double longest = 0;
  for (std::size_t v = 0; v < from.size(); ++v) {
    longest = std::max(longest, (to[v] - from[v]).norm());
  }
  return longest;
}

}  // namespace

Schema<FclStageParameters> FclStageParameters::schema() {
  using P = FclStageParameters;
  return Schema<P>()
      .key("thickness", &P::thickness, "m", positive(),
           "distance below which the centre lines of two strands push each other apart")
      .key("stiffness", &P::stiffness, "N/m", at_least(0),
           "of the response, per contact: the force at half the thickness is about half of its "
           "product with the thickness")
      .key("strand_contacts", &P::strand_contacts, "", any_number(),
           "whether strands feel each other and themselves")
      .key("push_at_rest", &P::push_at_rest, "", any_number(),
           "whether strands that are nearer than the thickness in their rest shape push each other "
           "even there")
      .key("rest_slack", &P::rest_slack, "", between(1e-6, 1),
           "else, by how much of their distance at rest they may come nearer before they push; 1: "
           "they never do")
      .key(
          "arc_distance", &P::arc_distance, "m", at_least(0),
          "two edges of one strand with less arc between them do not touch; twice the thickness if "
          "absent")
      .key("collider_thickness", &P::collider_thickness, "m", positive(),
           "distance below which a collider pushes a vertex away; half the thickness if absent")
      .key("collider_stiffness", &P::collider_stiffness, "N/m", at_least(0),
           "of the response of colliders, per vertex; that between strands if absent")
      .key("friction", &P::friction, "", at_least(0), "Coulomb's coefficient between strands")
      .key("collider_friction", &P::collider_friction, "", at_least(0),
           "Coulomb's coefficient of colliders; that between strands if absent")
      .key("sticking_speed", &P::sticking_speed, "m/s", positive(),
           "friction grows up to this relative speed and is full from there on: what should stick "
           "creeps more slowly")
      .key("audit", &P::audit, "", any_number(),
           "whether every step is checked for strands that passed through each other and vertices "
           "inside of colliders: the columns crossings and collider_depth of metrics.csv")
      .key("margin", &P::margin, "m", at_least(0),
           "candidates are collected this much further than the thickness, so that they last while "
           "strands move; half the thickness if absent")
      .key("detector", &P::detector, "", any_number(), "finds the edges that are near each other")
      .key("response", &P::response, "", any_number(), "how hard contacts are pushed apart")
      .key("detect", &P::detect, "", any_number(),
           "when candidates are collected anew: at every Newton iteration; once a step, which "
           "misses contacts; or when something has moved by so much of the margin that one could "
           "be missed")
      .key("colliders", &P::colliders, "", any_number(), "rigid bodies that strands may touch")
      .check([](P& p, const std::string&, ParseContext&) {
        p.arc_distance = p.arc_distance.value_or(2 * p.thickness);
        p.collider_thickness = p.collider_thickness.value_or(p.thickness / 2);
        p.collider_stiffness = p.collider_stiffness.value_or(p.stiffness);
        p.collider_friction = p.collider_friction.value_or(p.friction);
        p.margin = p.margin.value_or(p.thickness / 2);
      });
}

FclStage::FclStage(const FclStageParameters& parameters)
    : parameters_(parameters),
      response_(parameters.response.make()),
      collider_contacts_(
          make_all(parameters.colliders),
          {response_.get(), *parameters.collider_thickness, *parameters.collider_stiffness},
          *parameters.margin),
      friction_(parameters.friction, *parameters.collider_friction, parameters.sticking_speed) {}

void FclStage::bind(const Strands& strands, const StrandGroups& groups, const Motions& motions) {
  groups_ = &groups;
  chunks_ = make_edge_chunks(strands);
  collider_contacts_.bind(chunks_, motions);
  positions_.resize(strands.vertex_count());
  if (parameters_.strand_contacts) bind_strand_contacts(strands);
  if (parameters_.audit) audit_.emplace(continuous_ ? &*continuous_ : nullptr, collider_contacts_);
}

void FclStage::bind_strand_contacts(const Strands& strands) {
  rule_.emplace(strands, *parameters_.arc_distance);
  detector_ = parameters_.detector.make();
  detector_->bind(strands);
  if (!parameters_.push_at_rest) {
    rest_pairs_.emplace(strands, *detector_, parameters_.thickness, parameters_.rest_slack);
  }
  if (parameters_.audit || response_->is_barrier()) continuous_.emplace(strands, *rule_);
}

std::vector<Pin> FclStage::pins(const std::vector<Eigen::Vector3d>& positions) const {
  return collider_contacts_.pins(positions);
}

void FclStage::set_free(const VertexScalars& free) {
  std::vector<bool> is_free(groups_->vertex_count());
  for (int v = 0; v < groups_->vertex_count(); ++v) {
    const auto [row, lane] = groups_->slot(v);
    is_free[v] = free[row][lane] != 0;
  }
  if (rule_) rule_->set_free(is_free);
  collider_contacts_.set_free(std::move(is_free));
}

void FclStage::begin_step(const VertexField& x_n, double time_end, double dt) {
  collider_contacts_.move_to(time_end, dt);
  if (friction_.is_wanted()) friction_.begin_step(x_n, dt);
  is_new_step_ = true;
  is_swept_ = false;
  if (!audit_) return;
  gather(x_n);
  audit_->begin_step(positions_);
}

void FclStage::detect(const VertexField& x) {
  if (audit_) follow(x);
  find_candidates(x);
  if (friction_.is_wanted()) lag_friction(x);
}

void FclStage::find_candidates(const VertexField& x) {
  if (std::exchange(is_swept_, false)) return;
  if (parameters_.detect == DetectWhen::step && !is_new_step_) return;
  is_new_step_ = false;
  gather(x);
  if (parameters_.detect == DetectWhen::margin && are_candidates_valid()) return;
  collect_candidates();
}

void FclStage::gather(const VertexField& x) {
  parallel_for_each(static_cast<int>(positions_.size()), [&](int v) { positions_[v] = x.get(v); });
}

bool FclStage::are_candidates_valid() const {
  return is_covered(positions_, positions_, parameters_.thickness) &&
         collider_contacts_.are_valid(positions_, movement_);
}

// Whether all pairs that come nearer than reach on a straight way are candidates. Two edges come
// nearer to each other by no more than twice what a vertex moves.
bool FclStage::is_covered(std::span<const Eigen::Vector3d> from,
                          std::span<const Eigen::Vector3d> to, double reach) const {
  if (!movement_.has_started()) return false;
  const double allowed = (parameters_.thickness + *parameters_.margin - reach) / 2;
  const Eigen::Isometry3d common = movement_.rigid_part(to);
  return movement_.is_within(allowed, to, common) &&
         (from.data() == to.data() || movement_.is_within(allowed, from, common));
}

void FclStage::collect_candidates() {
  movement_.start_from(positions_);
  if (detector_) {
    detector_->find(positions_, parameters_.thickness + *parameters_.margin, pairs_);
    std::erase_if(pairs_, [&](const EdgePair& pair) { return !rule_->allows(pair); });
    limit_thickness();
  }
  collider_contacts_.detect(positions_);
}

void FclStage::limit_thickness() {
  thickness_.assign(pairs_.size(), parameters_.thickness);
  if (rest_pairs_) rest_pairs_->limit(pairs_, thickness_);
}

// A barrier pushes a pair that is near at rest, and so has a small thickness, with as large forces
// as any other: else loads would close its gap to nothing, where no step can go on.
double FclStage::stiffness_of(int p) const {
  if (!response_->is_barrier() || thickness_[p] == 0) return parameters_.stiffness;
  return parameters_.stiffness * parameters_.thickness / thickness_[p];
}

void FclStage::evaluate(const VertexField& x) {
  const int pairs = static_cast<int>(pairs_.size());
  strand_contacts_.collect((pairs + pairs_a_part - 1) / pairs_a_part, [&](int part, auto& found) {
    const int end = std::min(pairs, (part + 1) * pairs_a_part);
    for (int p = part * pairs_a_part; p < end; p += lane_count) {
      add_touching(p, std::min(lane_count, end - p), x, found);
    }
  });
  collider_contacts_.evaluate(x, touched_colliders_);
}

void FclStage::add_touching(int first, int count, const VertexField& x,
                            std::vector<Touching::Found>& found) const {
  const std::span<const EdgePair> pairs(&pairs_[first], count);
  const SegmentGaps gaps(pairs, x, parameters_.thickness);
  for (int n = 0; n < count; ++n) {
    const EdgePair& pair = pairs[n];
    const ContactLaw law{response_.get(), thickness_[first + n], stiffness_of(first + n)};
    const double distance = gaps.distances()[n];
    if (distance >= law.thickness) continue;
    const SegmentGap gap = distance == 0 ? gap_of(pair, x) : gaps.of(n);
    found.push_back({first + n,
                     {{pair.first, pair.first + 1, pair.second, pair.second + 1},
                      gap.weights,
                      gap.normal,
                      law.thickness - distance,
                      law.at(distance)}});
  }
}

// Friction is that of the forces, normals and closest points at x, until the next iteration.
void FclStage::lag_friction(const VertexField& x) {
  evaluate(x);
  friction_.clear();
  strand_contacts_.for_each(
      [&](int, const Contact& contact) { friction_.add_strand_contact(contact); });
  touched_colliders_.for_each([&](int candidate, const Contact& contact) {
    friction_.add_collider_contact(
        contact, collider_contacts_.displacement(candidate, x.get(contact.vertices[0])));
  });
}

void FclStage::follow(const VertexField& x) {
  gather(x);
  audit_->follow(positions_);
}

void FclStage::end_step(const VertexField& x) {
  if (!audit_) return;
  follow(x);
  audit_->end_step(report_);
}

bool FclStage::can_reach(const VertexField& x_n, VertexField& guess) {
  if (!response_->is_barrier()) return true;
  gather(x_n);
  std::vector<Eigen::Vector3d> start = positions_;
  gather(guess);
  collider_contacts_.carry_what_is_hit(start, positions_, movement_);
  for (std::size_t v = 0; v < start.size(); ++v) guess.set(static_cast<int>(v), positions_[v]);
  if (collider_contacts_.free_part_of_step(start, positions_, {vanishing}, movement_) < 1)
    return false;
  if (!continuous_) return true;
  bring_to(positions_, start);
  if (!is_covered(start, positions_, 0)) sweep(start, positions_, 0);
  return free_part_of_pairs(pairs_, thickness_, start, positions_, vanishing) == 1;
}

double FclStage::step_limit(const VertexField& x, const VertexField& d) {
  if (!response_->is_barrier()) return 1;
  gather(x);
  std::vector<Eigen::Vector3d> to(positions_.size());
  parallel_for_each(static_cast<int>(to.size()), [&](int v) { to[v] = positions_[v] - d.get(v); });
  find_candidates_of_way(to);
  return std::min(
      free_part_of_pairs(pairs_, thickness_, positions_, to, kept_part),
      collider_contacts_.free_part(positions_, to, {kept_part, *parameters_.collider_thickness}));
}

// Afterwards all that comes nearer than the thickness on a straight way is a candidate.
void FclStage::find_candidates_of_way(std::span<const Eigen::Vector3d> to) {
  const auto is_way_covered = [&] {
    return is_covered(positions_, to, parameters_.thickness) &&
           collider_contacts_.are_valid(positions_, movement_) &&
           collider_contacts_.are_valid(to, movement_);
  };
  if (is_way_covered()) return;
  collect_candidates();
  if (is_way_covered()) return;
  sweep(positions_, to, parameters_.thickness);
  collider_contacts_.detect(positions_, longest_distance(positions_, to));
  is_swept_ = true;
}

void FclStage::sweep(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
                     double reach) {
  movement_ = {};
  if (!continuous_) return;
  pairs_ = continuous_->find(from, to, reach);
  limit_thickness();
}

double FclStage::add(const VertexField& x, Couplings* couplings) {
  evaluate(x);
  report_ = {.strand_contacts = strand_contacts_.count(),
             .collider_contacts = touched_colliders_.count(),
             .penetration = std::max(strand_contacts_.depth(), touched_colliders_.depth())};
  if (couplings != nullptr) {
    strand_contacts_.add_terms(*couplings);
    touched_colliders_.add_terms(*couplings);
  }
  return strand_contacts_.energy() + touched_colliders_.energy() + friction_.add(x, couplings);
}

void register_fcl_stage(Registry& registry);
void register_fcl_stage(Registry& registry) {
  registry.of<CollisionStage>().add<FclStageParameters>(
      "fcl",
      {"contacts between strands, found by FCL, and with colliders", "sum of E(d) over d < h",
       "Shi et al., Lifted Curls, SCA 2023"},
      [](const FclStageParameters& parameters) { return std::make_unique<FclStage>(parameters); });
}

}  // namespace ringlet
