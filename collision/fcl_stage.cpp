// A collision stage on FCL's broad phase. The contact energy is a sum over all pairs of strand
// edges, and all vertices and colliders, of a function of their distance (see responses/); its
// thickness h is the distance at rest of two edges, where that is less.

#include "collision/fcl_stage.h"

#include <atomic>
#include <cstring>

#include "collision/continuous.h"
#include "core/parallel.h"

namespace ringlet {
namespace {

std::vector<std::unique_ptr<Collider>> make_all(const std::vector<Choice<Collider>>& choices) {
  std::vector<std::unique_ptr<Collider>> colliders;
  for (const auto& choice : choices) colliders.push_back(choice.make());
  return colliders;
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
           "strands move; the thickness if absent")
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
        p.margin = p.margin.value_or(p.thickness);
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
  evaluated_ = VertexField(groups);
  if (parameters_.strand_contacts) bind_strand_contacts(strands);
  if (parameters_.audit) {
    audit_.emplace(strand_contacts_ ? strand_contacts_->continuous() : nullptr, collider_contacts_);
  }
}

void FclStage::bind_strand_contacts(const Strands& strands) {
  StrandContacts::Parameters parameters{.thickness = parameters_.thickness,
                                        .stiffness = parameters_.stiffness,
                                        .margin = *parameters_.margin,
                                        .arc_distance = *parameters_.arc_distance,
                                        .rest_slack = parameters_.rest_slack,
                                        .with_ways = parameters_.audit || response_->is_barrier()};
  if (parameters_.push_at_rest) parameters.rest_slack.reset();
  strand_contacts_.emplace(strands, parameters_.detector.make(), *response_, parameters);
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
  if (strand_contacts_) strand_contacts_->set_free(is_free);
  collider_contacts_.set_free(std::move(is_free));
}

void FclStage::begin_step(const VertexField& x_n, double time_end, double dt) {
  collider_contacts_.move_to(time_end, dt);
  if (friction_.is_wanted()) friction_.begin_step(x_n, dt);
  is_new_step_ = true;
  is_swept_ = is_evaluated_ = false;
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
  if (parameters_.detect != DetectWhen::margin) {
    collect_candidates();
  } else if (!are_candidates_valid(positions_, positions_)) {
    collect_missing_candidates(positions_);
  }
}

void FclStage::gather(const VertexField& x) {
  parallel_for_each(static_cast<int>(positions_.size()), [&](int v) { positions_[v] = x.get(v); });
}

bool FclStage::are_candidates_valid(std::span<const Eigen::Vector3d> from,
                                    std::span<const Eigen::Vector3d> to) const {
  if (strand_contacts_ && !strand_contacts_->are_valid(from, to, parameters_.thickness)) {
    return false;
  }
  return collider_contacts_.are_valid(to) &&
         (from.data() == to.data() || collider_contacts_.are_valid(from));
}

void FclStage::collect_candidates() {
  is_evaluated_ = false;
  if (strand_contacts_) strand_contacts_->detect(positions_);
  collider_contacts_.detect(positions_);
}

// For a way from the positions.
void FclStage::collect_missing_candidates(std::span<const Eigen::Vector3d> to) {
  if (strand_contacts_ && !strand_contacts_->are_valid(positions_, to, parameters_.thickness) &&
      strand_contacts_->detect_moved(positions_, to)) {
    is_evaluated_ = false;
  }
  if (!collider_contacts_.are_valid(positions_) || !collider_contacts_.are_valid(to)) {
    collider_contacts_.detect(positions_);
    is_evaluated_ = false;
  }
}

// A line search ends where the next iteration begins.
void FclStage::evaluate(const VertexField& x) {
  if (is_evaluated_ && is_evaluated_at(x)) return;
  parallel_for_each(groups_->count(), [&](int g) {
    std::copy(x.group(g).begin(), x.group(g).end(), evaluated_.group(g).begin());
  });
  is_evaluated_ = true;
  if (strand_contacts_) strand_contacts_->evaluate(x, touching_strands_);
  collider_contacts_.evaluate(x, touching_colliders_);
}

bool FclStage::is_evaluated_at(const VertexField& x) const {
  std::atomic<bool> is_same = true;
  parallel_for_each(groups_->count(), [&](int g) {
    const auto rows = x.group(g), evaluated = evaluated_.group(g);
    if (is_same && std::memcmp(rows.data(), evaluated.data(), rows.size_bytes()) != 0) {
      is_same = false;
    }
  });
  return is_same;
}

// Friction is that of the forces, normals and closest points at x, until the next iteration.
void FclStage::lag_friction(const VertexField& x) {
  evaluate(x);
  friction_.clear();
  touching_strands_.for_each(
      [&](int, const Contact& contact) { friction_.add_strand_contact(contact); });
  touching_colliders_.for_each([&](int candidate, const Contact& contact) {
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
  std::vector<Eigen::Vector3d> start(positions_.begin(), positions_.end());
  gather(guess);
  collider_contacts_.carry_what_is_hit(start, positions_);
  for (std::size_t v = 0; v < start.size(); ++v) guess.set(static_cast<int>(v), positions_[v]);
  if (collider_contacts_.free_part_of_step(start, positions_, {vanishing}) < 1) {
    return false;
  }
  if (!strand_contacts_) return true;
  bring_to(positions_, start);
  if (!strand_contacts_->are_valid(start, positions_, 0)) {
    is_evaluated_ = false;
    strand_contacts_->detect_on_way(start, positions_, 0);
  }
  return strand_contacts_->free_part(start, positions_, vanishing) == 1;
}

double FclStage::step_limit(const VertexField& x, const VertexField& d) {
  if (!response_->is_barrier()) return 1;
  gather(x);
  std::vector<Eigen::Vector3d> to(positions_.size());
  parallel_for_each(static_cast<int>(to.size()), [&](int v) { to[v] = positions_[v] - d.get(v); });
  find_candidates_of_way(to);
  const double free_of_colliders =
      collider_contacts_.free_part(positions_, to, {kept_part, *parameters_.collider_thickness});
  if (!strand_contacts_) return free_of_colliders;
  return std::min(free_of_colliders, strand_contacts_->free_part(positions_, to, kept_part));
}

// Afterwards all that comes nearer than the thickness on a straight way is a candidate.
void FclStage::find_candidates_of_way(std::span<const Eigen::Vector3d> to) {
  if (are_candidates_valid(positions_, to)) return;
  collect_missing_candidates(to);
  if (are_candidates_valid(positions_, to)) return;
  is_evaluated_ = false;
  if (strand_contacts_) strand_contacts_->detect_on_way(positions_, to, parameters_.thickness);
  collider_contacts_.detect_on_way(positions_, longest_distance(positions_, to));
  is_swept_ = true;
}

double FclStage::add(const VertexField& x, Couplings* couplings) {
  evaluate(x);
  report_ = {.strand_contacts = touching_strands_.count(),
             .collider_contacts = touching_colliders_.count(),
             .penetration = std::max(touching_strands_.depth(), touching_colliders_.depth())};
  if (couplings != nullptr) {
    touching_strands_.add_terms(*couplings);
    touching_colliders_.add_terms(*couplings);
  }
  return touching_strands_.energy() + touching_colliders_.energy() + friction_.add(x, couplings);
}

std::size_t FclStage::bytes() const {
  return (strand_contacts_ ? strand_contacts_->bytes() : 0) + collider_contacts_.bytes() +
         touching_strands_.bytes() + touching_colliders_.bytes() + bytes_of(chunks_) +
         bytes_of(positions_) + evaluated_.bytes();
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
