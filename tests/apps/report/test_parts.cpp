#include <cmath>
#include <random>

#include "apps/report/metrics_table.h"
#include "apps/report/packed_text.h"
#include "apps/report/quantised.h"
#include "apps/report/thinning.h"
#include "tests/apps/report/unpack.h"
#include "tests/catch.h"
#include "tests/temporary_file.h"

using namespace ringlet;

TEST_CASE("packed text: bytes come back, whatever their number") {
  for (const std::size_t size : {0, 1, 2, 3, 4, 1000}) {
    std::vector<std::uint8_t> bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * i);
    CHECK(unpack_text(pack_text(bytes)) == bytes);
  }
}

TEST_CASE("thinning: frames go first, then strands, and the budget is kept") {
  const std::int64_t vertices = 1000, frame = 6 * vertices;
  CHECK(thin(300, vertices, 10, 300 * frame).every_frame == 1);
  const Thinning third = thin(301, vertices, 10, 101 * frame);
  CHECK(third.every_frame == 3);
  CHECK(third.every_strand == 1);
  const Thinning few = thin(301, vertices, 10, 20 * frame);
  CHECK(kept(301, few.every_frame, true).size() <= fewest_frames);
  CHECK(kept(301, few.every_frame, true).size() > fewest_frames / 2);
  CHECK(few.every_strand == 3);
  for (const int frames : {1, 2, 59, 61, 240, 1000}) {
    for (const std::int64_t budget : {std::int64_t{1}, 7 * frame, 100 * frame, 2000 * frame}) {
      const Thinning thinning = thin(frames, vertices, 10, budget);
      const auto shown = static_cast<std::int64_t>(kept(frames, thinning.every_frame, true).size());
      CHECK((shown * frame / thinning.every_strand <= budget || thinning.every_strand == 10));
    }
  }
}

TEST_CASE("thinning: what stays is evenly spaced, with the last frame") {
  CHECK(kept(7, 3, true) == std::vector<int>{0, 3, 6});
  CHECK(kept(8, 3, true) == std::vector<int>{0, 3, 6, 7});
  CHECK(kept(8, 3, false) == std::vector<int>{0, 3, 6});
  CHECK(kept(1, 5, true) == std::vector<int>{0});
}

TEST_CASE("quantised positions are within half a step of the true ones") {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> number(-0.3f, 1.2f);
  std::vector<std::vector<float>> frames(3, std::vector<float>(30));
  for (auto& frame : frames) {
    for (float& coordinate : frame) coordinate = number(random);
    for (std::size_t i = 2; i < frame.size(); i += 3) frame[i] = 0.25f;  // all in a plane
  }
  const Quantisation box = Quantisation::around(frames);
  CHECK(box.step[0] < 1.5 / 65535);
  CHECK(box.step[2] == 0);
  for (const auto& frame : frames) {
    const auto steps = box.quantise(frame);
    for (std::size_t i = 0; i < frame.size(); ++i) {
      const double back = box.low[i % 3] + box.step[i % 3] * steps[i];
      CHECK(std::abs(back - frame[i]) <= 0.5 * box.step[i % 3] + 1e-12);
    }
  }
}

TEST_CASE("a row of metrics.csv that is still being written is left out") {
  const TemporaryFile file("csv", "step,time,crossings\n1,0.5,\n2,1,3\n3,1.,2");
  const MetricsTable table = read_metrics_table(file.path());
  CHECK(table.names == std::vector<std::string>{"step", "time", "crossings"});
  REQUIRE(table.rows() == 2);
  CHECK(table.columns[1] == std::vector<double>{0.5, 1});
  CHECK(std::isnan(table.columns[2][0]));
  CHECK(table.columns[2][1] == 3);
  CHECK(read_metrics_table("no/such/file").rows() == 0);
}
