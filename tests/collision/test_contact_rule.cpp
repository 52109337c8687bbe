#include "collision/contact_rule.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("edges of one strand need arc between them to be a contact") {
  const Strands strands(
      {6, 2},
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}, {5, 0, 0}, {0, 1, 0}, {1, 1, 0}},
      Material{});
  const ContactRule anything(strands, 0), far(strands, 1.5);
  CHECK_FALSE(anything.allows({0, 1}));  // they share a vertex
  CHECK(anything.allows({0, 2}));
  CHECK_FALSE(far.allows({0, 2}));  // 1 m apart
  CHECK(far.allows({0, 3}));        // 2 m apart
  CHECK(far.allows({4, 6}));        // of two strands
}

TEST_CASE("edges that cannot move are no contact") {
  const Strands strands({3, 3}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}},
                        Material{});
  ContactRule rule(strands, 0);
  rule.set_free({false, false, true, false, false, true});
  CHECK_FALSE(rule.allows({0, 3}));
  CHECK(rule.allows({0, 4}));
  CHECK(rule.allows({1, 4}));
}
