#include "plugins/usda/usda_reader.h"
#include "tests/plugins/usda/read_usda.h"
#include "tests/plugins/written_run.h"

using namespace ringlet;

namespace {

/// What the file holds after some steps, of which these have been written.
void check_content(const WrittenRun& run, const std::vector<int>& steps) {
  const UsdaContent content = read_usda(bytes_in(run.folder.path() / "run.usda"));
  CHECK(content.vertex_counts == std::vector<int>{2, 3});
  REQUIRE(content.widths.size() == 5);
  for (int v = 0; v < 5; ++v) {
    CHECK(content.widths[v] == Approx(2 * run.model.strands.radius(v)).epsilon(1e-6));
  }
  REQUIRE(content.time_codes.size() == steps.size());
  Eigen::AlignedBox3f box;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    CHECK(content.time_codes[i] == WrittenRun::time(steps[i]) * 60);
    REQUIRE(content.points[i].size() == 15);
    for (int v = 0; v < 5; ++v) {
      const Eigen::Vector3f x(&content.points[i][3 * v]);
      CHECK(x == WrittenRun::position(v, steps[i]).cast<float>());
      box.extend(x);
    }
  }
  CHECK(content.start == 0);
  CHECK(content.end == content.time_codes.back());
  CHECK(content.time_codes_per_second == 60);
  REQUIRE(content.extent.size() == 6);
  CHECK(Eigen::Vector3f(&content.extent[0]) == box.min());
  CHECK(Eigen::Vector3f(&content.extent[3]) == box.max());
}

const Json every_second{{"type", "usda"}, {"every", 2}, {"time_codes_per_second", 60}};

/// A file with one strand, of which something may be changed.
std::string small(const std::string& from = "", const std::string& to = "") {
  std::string text =
      "#usda 1.0\n( upAxis = \"Y\"\n metersPerUnit = 1\n timeCodesPerSecond = 10 )\n"
      "def BasisCurves \"hair\" {\n uniform token type = \"linear\"\n"
      " int[] curveVertexCounts = [2]\n float[] widths = [0.5, 0.25]\n"
      " point3f[] points.timeSamples = { 0: [(0, 1, 2), (3, 4, 5)], 5: [(0, 1, 2), (6, 7, 8)] }\n"
      "}\n";
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  return text;
}

UsdaReader read_text(const std::string& text) {
  const TemporaryFile file("usda", text);
  return UsdaReader(file.path());
}

}  // namespace

TEST_CASE("run.usda is whole after each state, and what it should be to the letter") {
  WrittenRun run(every_second);
  check_content(run, {0});
  run.steps(1, 2);
  check_content(run, {0, 2});
  run.steps(3, 5);
  check_content(run, {0, 2, 4});
  run.end(5);
  check_content(run, {0, 2, 4, 5});
  run.end(5);
  check_content(run, {0, 2, 4, 5});
}

TEST_CASE("run.usda is whole also where a state and the extent are shorter than those before") {
  const std::vector<Eigen::Vector3d> rest{{1 / 3.0, 2 / 3.0, 1 / 7.0}, {4 / 3.0, 5 / 3.0, 8 / 7.0}};
  const Model model(Strands({2}, rest, Material{}));
  State state{0, positions_with_pads(model.groups, rest), VertexField(model.groups)};
  const TemporaryFolder folder;
  const auto writer = make_of_plugins<Observer>("usda");
  writer->begin(model, state, folder.path());
  state.time = 1;
  for (const int v : {0, 1}) state.positions.set(v, Eigen::Vector3d::Constant(v == 0 ? -9 : 9));
  writer->observe(model, state, 1, {});
  CHECK(read_usda(bytes_in(folder.path() / "run.usda")).extent ==
        std::vector<float>{-9, -9, -9, 9, 9, 9});
}

TEST_CASE("run.usda goes on after a break, wherever it was torn, and ends as without one") {
  WrittenRun whole(every_second), broken(every_second);
  for (WrittenRun* run : {&whole, &broken}) run->steps(1, 4);
  const std::string at_break = bytes_in(broken.folder.path() / "run.usda");
  const std::size_t samples = at_break.find("    }\n    float3[] extent");
  whole.steps(5, 6);
  whole.end(6);
  const std::string path = broken.folder.path() / "run.usda";
  const std::string expected = bytes_in(whole.folder.path() / "run.usda");
  const std::string later = expected.substr(samples);
  for (std::size_t size = 0; size < later.size(); size += 7) {
    CAPTURE(size);
    std::ofstream(path, std::ios::binary) << at_break.substr(0, samples) + later.substr(0, size);
    broken.resume(every_second, 4);
    CHECK(bytes_in(path) == at_break);
    broken.steps(5, 6);
    broken.end(6);
    CHECK(bytes_in(path) == expected);
  }
  broken.resume(every_second, 3);
  check_content(broken, {0, 2});
  broken.end(3);
  check_content(broken, {0, 2, 3});
  broken.resume(every_second, 3);
  check_content(broken, {0, 2});
}

TEST_CASE("what is no run.usda of the same strands and parameters is not gone on with") {
  WrittenRun run(every_second);
  const std::string path = run.folder.path() / "run.usda";
  const std::string whole = bytes_in(path);
  CHECK_THROWS_WITH(run.resume("usda", 0), Catch::Contains("of other strands or parameters"));
  for (const std::size_t size : {std::size_t{0}, std::size_t{100}, whole.find("widths")}) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, size);
    CHECK_THROWS_WITH(run.resume(every_second, 0), Catch::Contains("of other strands"));
  }
  std::ofstream(path, std::ios::binary) << whole.substr(0, whole.find("        0: ["));
  CHECK_THROWS_WITH(run.resume(every_second, 0), Catch::Contains("holds no whole state"));
}

TEST_CASE("run.usda is read back, all states with their times, and the first as strands") {
  WrittenRun run(every_second);
  run.steps(1, 4);
  UsdaReader reader(run.folder.path() / "run.usda");
  REQUIRE(reader.times().size() == 3);
  for (int sample = 0; sample < 3; ++sample) {
    CHECK(reader.times()[sample] == Approx(WrittenRun::time(2 * sample)));
    const Eigen::Matrix3Xd x = reader.read(sample);
    Polylines strands{reader.vertex_counts(), {}, reader.radii()};
    for (int v = 0; v < x.cols(); ++v) strands.positions.emplace_back(x.col(v));
    run.check(strands, 2 * sample);
  }
  run.check(read_strands(run.folder.path() / "run.usda"), 0);
}

TEST_CASE("curves of another program are read in metres, with +y up") {
  UsdaReader reader = read_text(
      "#usda 1.0\n(\n    \"\"\"made (by hand\"\"\"\n    customLayerData = { string a = \"}\" }\n"
      "    prepend subLayers = [@a)b.usda@]\n    metersPerUnit = 0.01\n    upAxis = \"Z\"\n)\n"
      "def Xform \"top\" (\n    kind = \"group\"\n)\n{\n    # def BasisCurves\n"
      "    def Scope \"empty\" { rel material:binding = </a/b> }\n"
      "    def BasisCurves \"hair\" {\n        uniform token type = 'linear'\n"
      "        int[] curveVertexCounts = [2, 1,]; float[] widths = [3] "
      "( interpolation = \"constant\" )\n"
      "        variantSet \"look\" = { \"a\" { float x = 1 } }\n"
      "        point3f[] points = [(100, 200, 300), (1e2, -2, .5),\n (0, 0, 0)]\n    }\n}\n");
  CHECK(reader.times() == std::vector<double>{0});
  CHECK(reader.vertex_counts() == std::vector<int>{2, 1});
  REQUIRE(reader.radii().size() == 3);
  CHECK(reader.radii()[2] == Approx(0.015));
  const Eigen::Matrix3Xd x = reader.read(0);
  CHECK((x.col(0) - Eigen::Vector3d(1, 3, -2)).norm() < 1e-15);
}

TEST_CASE("a .usda that is wrong is refused with file, line and reason") {
  CHECK(reason_against("usda", small()).empty());
  CHECK(read_text(small()).times() == std::vector<double>{0, 0.5});
  const std::vector<std::array<std::string, 3>> table{
      {"#usda 1.0", "#usda 2.0", "line 1: expected '#usda 1.0'"},
      {"metersPerUnit = 1", "metersPerUnit = 0", "expected metersPerUnit > 0"},
      {"timeCodesPerSecond = 10", "timeCodesPerSecond = -1", "expected timeCodesPerSecond > 0"},
      {"BasisCurves", "Mesh", "expected BasisCurves"},
      {" uniform token type = \"linear\"\n", "", "curves of the type \"linear\""},
      {"\"linear\"", "\"cubic\"",
       "line 6: expected curves of the type \"linear\", found \"cubic\""},
      {"widths = [0.5, 0.25]", "widths = [1, 2, 3]",
       "expected widths of 2 vertices in all, found 3"},
      {"0.25]", "-1]", "expected widths >= 0"},
      {"[2]", "[0]", "expected numbers of vertices from 1"},
      {"[2]", "[2000000000]", "expected widths of 2000000000 vertices"},
      {"[2]", "[1e300]", "expected a finite number"},
      {"[2]", "[]", "expected BasisCurves with curveVertexCounts"},
      {"[2]", "[2 3]", "expected ',' or ']'"},
      {"(0, 1, 2), (3", "(3", "expected 2 points, as curveVertexCounts says, found 1"},
      {"(0, 1, 2)", "(0, nan, 2)", "line 9: expected a finite number"},
      {"(0, 1, 2)", "(0, 1e39, 2)", "expected a finite number"},
      {"(0, 1, 2)", "(0, 1)", "expected ','"},
      {"(0, 1, 2)", "(0, 1, 2", "found '"},
      {"5: [", "0: [", "expected time samples in ascending order"},
      {"5: [", "5 [", "expected ':'"},
      {"uniform token type", "double3 xformOp:translate = (1, 2, 3) token type",
       "expected curves without transforms, found 'xformOp:translate'"},
      {"def BasisCurves", "def BasisCurves \"a\" {} def BasisCurves", "found another"},
      {"\"hair\"", "\"hair", "expected '{'"},
      {"8)] }\n}", "8)] }", "expected a property"},
      {"upAxis", "= upAxis", "expected a key"}};
  for (const auto& [from, to, reason] : table) {
    CAPTURE(from, to);
    CHECK_THAT(reason_against("usda", small(from, to)), Catch::Contains(reason));
  }
  std::string deep = "#usda 1.0\n";
  for (int i = 0; i < 200000; ++i) deep += "def X \"a\" {";
  CHECK_THAT(reason_against("usda", deep), Catch::Contains("less deep"));
}

TEST_CASE("damaged .usda files are read or refused, never crashed on") {
  damage_everywhere("usda", small());
}
