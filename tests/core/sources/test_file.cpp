#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>

#include <sstream>

#include "core/strand_source.h"
#include "tests/core/readers/hostile_file.h"

using namespace ringlet;

namespace {

// A strand of four vertices, the third of them 1 mm from the second; a point; a strand of two.
const std::string groom =
    "v 0 0 0\nv 0 1 0\nv 0 1.001 0\nv 0 2 0\nl 1 2 3 4\n"
    "v 5 0 0\nv 5 1e-7 0\nl 5 6\n"
    "v 7 0 0\nv 7 1 0\nl 7 8\n";

// Collects what is logged in its scope.
class CapturedLog {
 public:
  CapturedLog() : before_(spdlog::default_logger()) {
    const auto sink = std::make_shared<spdlog::sinks::ostream_sink_st>(text_);
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("captured", sink));
  }
  ~CapturedLog() { spdlog::set_default_logger(before_); }
  CapturedLog(const CapturedLog&) = delete;
  CapturedLog& operator=(const CapturedLog&) = delete;

  std::string text() const { return text_.str(); }

 private:
  std::shared_ptr<spdlog::logger> before_;
  std::ostringstream text_;
};

Json source(const TemporaryFile& file) {
  return {{"type", "file"}, {"path", file.path().string()}};
}

}  // namespace

TEST_CASE("a file source merges short edges, drops points, and pins what is left") {
  const TemporaryFile file("obj", groom);
  Json json = source(file);
  json["pinned"] = 3;
  json["motion"] = "nod";
  const CapturedLog log;
  const StrandSet set = make_plugin<StrandSource>(json)->generate();
  CHECK(contains(log.text(),
                 "1 vertices no further than 0.0999 m from their neighbour merged, "
                 "1 of 3 strands dropped"));
  CHECK(set.vertex_counts == std::vector<int>{3, 2});
  CHECK(set.pinned_counts == std::vector<int>{3, 2});
  CHECK(set.motions == std::vector<std::string>{"nod", "nod"});
  CHECK(set.positions[2] == Eigen::Vector3d(0, 2, 0));
}

TEST_CASE("the unit and the shortest edge of a file can be given") {
  const TemporaryFile file("obj", groom);
  Json json = source(file);
  json["scale"] = 0.01;
  json["minimum_edge"] = 0;
  const CapturedLog log;
  const StrandSet set = make_plugin<StrandSource>(json)->generate();
  CHECK(set.vertex_counts == std::vector<int>{4, 2, 2});
  CHECK(log.text().empty());
  CHECK(set.positions[3].y() == Approx(0.02));
}

TEST_CASE("the format of a file is known by its extension or told") {
  const CapturedLog log;
  const TemporaryFile file("obj", groom);
  CHECK(read_plugin<StrandSource>(source(file)).choice.resolved()["format"]["type"] == "obj");
  const TemporaryFile other("mesh", groom);
  CHECK(read_plugin<StrandSource>(source(other))
            .has_one_problem("/path", "no strand reader for files named '.mesh'"));
  Json told = source(other);
  told["format"] = "obj";
  CHECK(make_plugin<StrandSource>(told)->generate().vertex_counts.size() == 2);
}

TEST_CASE("a file of points only is refused") {
  const CapturedLog log;
  const TemporaryFile file("obj", "v 0 0 0\nl 1 1\n");
  CHECK_THROWS_AS(make_plugin<StrandSource>(source(file))->generate(), Error);
}

TEST_CASE("bad parameters of a file source are reported") {
  CHECK(read_plugin<StrandSource>({{"type", "file"}, {"path", "nowhere.hair"}})
            .has_one_problem("/path", "there is no file"));
  CHECK(read_plugin<StrandSource>("file").has_one_problem("/path", "missing"));
  const TemporaryFile file("obj", groom);
  const auto with = [&](const char* key, const Json& value) {
    Json json = source(file);
    json[key] = value;
    return read_plugin<StrandSource>(json);
  };
  CHECK(with("scale", 0).has_one_problem("/scale", "> 0 in m"));
  CHECK(with("minimum_edge", -1).has_one_problem("/minimum_edge", ">= 0 in m"));
  CHECK(with("pinned", -1).has_one_problem("/pinned", ">= 0"));
  CHECK(with("format", "hairr").has_one_problem("/format/type", "did you mean 'hair'"));
}
