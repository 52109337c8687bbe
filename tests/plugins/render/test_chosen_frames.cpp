#include "apps/render/chosen_frames.h"
#include "core/error.h"
#include "tests/catch.h"

using namespace ringlet;

namespace {

const std::vector<int> steps{0, 4, 8, 12, 16, 18};

std::string refusal_of(std::optional<int> frame, const std::optional<std::string>& range) {
  try {
    chosen_frames(steps, frame, range);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("frames are chosen by their steps") {
  CHECK(chosen_frames(steps, {}, {}) == std::vector<int>{5});
  CHECK(chosen_frames(steps, 8, {}) == std::vector<int>{2});
  CHECK(chosen_frames(steps, {}, "4:16") == std::vector<int>{1, 2, 3, 4});
  CHECK(chosen_frames(steps, {}, "3:100") == std::vector<int>{1, 2, 3, 4, 5});
  CHECK(chosen_frames(steps, {}, "0:18:8") == std::vector<int>{0, 2, 4});
}

TEST_CASE("frames that there are not are refused, and those that there are told") {
  CHECK(refusal_of(5, {}) == "--frame 5: there is no such frame; there are 6, of steps 0 to 18");
  CHECK(refusal_of({}, "19:30") ==
        "--frames 19:30: there is no such frame; there are 6, of steps 0 to 18");
  for (const char* text : {"", "4", "4:", ":8", "4:8:", "4:8:0", "4:8:1:1", "a:8", "4-8", "4:8x"}) {
    CAPTURE(text);
    CHECK(refusal_of({}, text).find("expected A:B or A:B:EVERY") != std::string::npos);
  }
  CHECK(refusal_of(4, "4:8").find("not both") != std::string::npos);
}
