#include <numbers>

#include "collision/audit.h"
#include "tests/catch.h"
#include "tests/collision/random_strands.h"

using namespace ringlet;

namespace {

/// An edge along x and one along y, above it; an audit of them.
struct Audited {
  Strands strands{{2, 2}, {{-1, 0, 0}, {1, 0, 0}, {0, -1, 0.5}, {0, 1, 0.5}}, Material{}};
  ContactRule rule{strands, 0};
  ContinuousDetection continuous{strands, rule};
  ColliderContacts colliders{{}, {nullptr, 1, 1}, 0};
  Audit audit{&continuous, colliders};

  /// The upper edge goes from place to place, given relative to where it starts.
  double crossings(const Points& places) {
    const auto at = [&](const Eigen::Vector3d& place) {
      Points positions = rest_positions(strands);
      for (const int v : {2, 3}) positions[v] += place;
      return positions;
    };
    audit.begin_step(at({0, 0, 0}));
    audit.follow(at({0, 0, 0}));
    for (const auto& place : places) audit.follow(at(place));
    ContactReport report;
    audit.end_step(report);
    return report.crossings;
  }
};

}  // namespace

TEST_CASE("the audit counts pairs that end on the other side of each other") {
  Audited audited;
  CHECK(audited.crossings({{0, 0, -0.4}}) == 0);
  CHECK(audited.crossings({{0, 0, -1}}) == 1);
  CHECK(audited.crossings({{0, 0, -0.4}, {0, 0, -1}, {0, 0, -2}}) == 1);
  CHECK(audited.crossings({{0, 0, -1}, {0, 0, 0.1}}) == 0);
}

TEST_CASE("the audit sees that an edge went around the end of another") {
  Audited audited;
  CHECK(audited.crossings({{3, 0, 0}, {3, 0, -1}, {0, 0, -1}}) == 0);
}

TEST_CASE("the audit sees no crossing in a motion of all") {
  Audited audited;
  const Points start = rest_positions(audited.strands);
  const Eigen::Isometry3d turn(
      Eigen::Translation3d(5, 0, 0) *
      Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d(1, 1, 0).normalized()));
  Points end;
  for (const auto& p : start) end.push_back(turn * p);
  audited.audit.begin_step(start);
  audited.audit.follow(end);
  ContactReport report;
  audited.audit.end_step(report);
  CHECK(report.crossings == 0);
}
