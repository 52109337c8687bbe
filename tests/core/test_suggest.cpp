#include "core/suggest.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("the nearest word is the one a typing error away") {
  const std::vector<std::string> known{"radius", "pitch", "curl_radius", "vertices"};
  CHECK(nearest_word("raduis", known) == "radius");
  CHECK(nearest_word("vertice", known) == "vertices");
  CHECK(nearest_word("curl_radus", known) == "curl_radius");
}

TEST_CASE("nothing is suggested where nothing is near") {
  CHECK(nearest_word("gravity", {"radius", "pitch"}).empty());
  CHECK(nearest_word("", {"a", "b"}).empty());
  CHECK(did_you_mean("gravity", {"radius", "pitch"}) == "known are: radius, pitch");
  CHECK(did_you_mean("gravity", {}) == "none are known");
  CHECK(did_you_mean("ptich", {"radius", "pitch"}) == "did you mean 'pitch'?");
}
