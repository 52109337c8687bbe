#include <fstream>

#include "apps/commands/command.h"
#include "apps/convert/input_frames.h"
#include "apps/convert/write_again.h"
#include "collision/modules.h"
#include "core/modules.h"
#include "energies/modules.h"
#include "plugins/modules.h"
#include "solvers/modules.h"
#include "tests/apps/program.h"
#include "tests/catch.h"

using namespace ringlet;
namespace fs = std::filesystem;

namespace {

/// What a writer is shown.
struct Shown {
  std::size_t pins = 0;
  std::vector<int> steps;
  std::vector<double> times;
  std::vector<Eigen::Vector3d> first_velocities;
};

class Witness final : public Observer {
 public:
  explicit Witness(Shown& shown) : shown_(shown) {}
  void begin(const Model& model, const State& state, const fs::path&) override {
    shown_.pins = model.pins.size();
    see(state, 0);
  }
  void observe(const Model&, const State& state, int step, const StepReport&) override {
    see(state, step);
  }
  void end(const Model&, const State&, int) override {}

 private:
  void see(const State& state, int step) {
    shown_.steps.push_back(step);
    shown_.times.push_back(state.time);
    shown_.first_velocities.push_back(state.velocities.get(0));
  }
  Shown& shown_;
};

/// `ringlet convert` in a folder that holds a run of three frames, run/frames.bin.
struct Converter {
  Converter() {
    register_core(registry);
    register_energies(registry);
    register_solvers(registry);
    register_collision(registry);
    register_plugins(registry);
    registry.of<Observer>().add<NoParameters>("witness", {"", "", ""}, [this](const NoParameters&) {
      return std::make_unique<Witness>(shown);
    });
    fs::create_directories(place.path() / "run");
    convert_again(run_frames(), "frames", "run");
  }

  static InputFrames run_frames() {
    return {{2, 3}, radii, {0, 2, 5}, [](int number) {
              const int step = std::vector{0, 2, 5}[static_cast<std::size_t>(number)];
              return RunFrame{step, 0.1 * step, positions(step)};
            }};
  }
  static Eigen::Matrix3Xd positions(int step) {
    Eigen::Matrix3Xd x(3, 5);
    for (int v = 0; v < 5; ++v) x.col(v) = Eigen::Vector3d(v / 7.0, v * v / 3.0, 0.3 * step);
    return x;
  }
  static inline const std::vector<double> radii{1e-3, 2e-3, 3e-3, 4e-3, 5e-3};

  void convert_again(const InputFrames& frames, const std::string& writer,
                     const std::string& folder) {
    const auto model = model_of(frames, registry);
    const State state{0, VertexField(model->groups), VertexField(model->groups)};
    std::vector<Problem> problems;
    ParseContext context{registry, place.path(), {}, problems};
    Choice<Observer> choice;
    Codec<Choice<Observer>>::read(writer, "", {}, context, choice);
    write_again(frames, *model, state, *choice.make(), path(folder));
  }

  fs::path path(const std::string& name) const { return place.path() / name; }
  /// Of the command with these names in the folder. Throws Error.
  int convert(const std::string& in, const std::string& out,
              std::vector<std::string> options = {}) {
    const Command command = convert_command();
    options.insert(options.end(), {path(in).string(), path(out).string()});
    return command.run(registry, Arguments(options, command.operands, command.options));
  }
  std::string refusal(const std::string& in, const std::string& out,
                      const std::vector<std::string>& options = {}) {
    try {
      convert(in, out, options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  InputFrames open(const std::string& name) { return open_input(path(name), {}, registry); }

  /// Whether a frame is the state of a step, to single precision.
  static void check(const InputFrames& frames, int number, int step, bool has_radii) {
    CHECK(frames.vertex_counts == std::vector<int>{2, 3});
    CHECK(frames.read(number).positions.cast<float>() == positions(step).cast<float>());
    REQUIRE(frames.radii.size() == 5);
    for (int v = 0; v < 5; ++v) {
      const double expected = has_radii ? radii[static_cast<std::size_t>(v)] : 4e-5;
      CHECK(frames.radii[static_cast<std::size_t>(v)] == Approx(expected).epsilon(1e-6));
    }
  }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(place.path())) {
      names.push_back(entry.path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  TemporaryFolder place;
  Registry registry;
  Shown shown;
};

struct Format {
  std::string extension;
  bool has_radii;
};

const std::vector<Format> formats{{"obj", false}, {"ply", true},  {"hair", true}, {"data", false},
                                  {"vtp", true},  {"usda", true}, {"bin", true},  {"pvd", true}};

}  // namespace

TEST_CASE("a state is converted from every format to every other") {
  Converter files;
  for (const auto& [from, from_radii] : formats) {
    files.convert("run", "one." + from, {"--frame", "2"});
    for (const auto& [to, to_radii] : formats) {
      CAPTURE(from, to);
      const std::string out = from + "_as." + to;
      CHECK(files.convert("one." + from, out) == 0);
      const InputFrames frames = files.open(out);
      CHECK(frames.steps.size() == 1);
      Converter::check(frames, 0, 2, from_radii && to_radii);
    }
  }
}

TEST_CASE("all frames of a run are converted to every format") {
  Converter files;
  for (const auto& [to, has_radii] : formats) {
    CAPTURE(to);
    const std::string name = "all_" + to;
    files.convert("run", name + "." + to);
    const bool in_one_file = to == "usda" || to == "bin" || to == "pvd";
    const std::vector<int> steps{0, 2, 5};
    for (int number = 0; number < 3; ++number) {
      const int step = steps[static_cast<std::size_t>(number)];
      const InputFrames frames = files.open(
          in_one_file ? name + "." + to : name + "_0000" + std::to_string(step) + "." + to);
      Converter::check(frames, in_one_file ? number : 0, step, has_radii);
      if (!in_one_file) continue;
      CHECK(frames.steps == (to == "usda" ? std::vector<int>{0, 1, 2} : steps));
      CHECK(frames.read(number).time == Approx(0.1 * step));
    }
    CHECK(fs::exists(files.path(name + "." + to)) == in_one_file);
  }
  CHECK(fs::exists(files.path("all_pvd_00005.vtp")));
}

TEST_CASE("all frames go from one file of many to another") {
  Converter files;
  for (const std::string from : {"usda", "bin", "pvd"}) {
    files.convert("run", "many." + from);
    for (const std::string to : {"usda", "bin", "pvd"}) {
      CAPTURE(from, to);
      files.convert("many." + from, from + "_as." + to);
      const InputFrames frames = files.open(from + "_as." + to);
      REQUIRE(frames.steps.size() == 3);
      Converter::check(frames, 2, 5, true);
      CHECK(frames.read(2).time == Approx(0.5));
    }
  }
}

TEST_CASE("an index of any name points to its frames") {
  Converter files;
  const std::string name = "a&b <\"c\"> &lt;.pvd";
  files.convert("run", name);
  Converter::check(files.open(name), 2, 5, true);
}

TEST_CASE("files are not overwritten unless asked, and nothing else is left behind") {
  Converter files;
  files.convert("run", "a.obj", {"--frame", "0"});
  CHECK_THAT(files.refusal("run", "a.obj", {"--frame", "5"}), Catch::Contains("--force"));
  Converter::check(files.open("a.obj"), 0, 0, false);
  files.convert("run", "a.obj", {"--frame", "5", "--force"});
  Converter::check(files.open("a.obj"), 0, 5, false);

  std::ofstream(files.path("b_00002.ply")) << "mine";
  CHECK_THAT(files.refusal("run", "b.ply"), Catch::Contains("b_00002.ply' exists"));
  CHECK(read_text(files.path("b_00002.ply")) == "mine");
  CHECK(files.names() == std::vector<std::string>{"a.obj", "b_00002.ply", "run"});
}

TEST_CASE("a frame that is damaged leaves no file") {
  Converter files;
  std::string bytes = read_text(files.path("run/frames.bin"));
  bytes[bytes.size() - 20] = static_cast<char>(bytes[bytes.size() - 20] + 1);
  std::ofstream(files.path("run/frames.bin"), std::ios::binary) << bytes;
  for (const auto& [to, has_radii] : formats) {
    CHECK_THAT(files.refusal("run", "all." + to), Catch::Contains("frame 2 is damaged"));
  }
  CHECK(files.names() == std::vector<std::string>{"run"});
}

TEST_CASE("what is wrong with a conversion is told before anything is written") {
  Converter files;
  files.convert("run", "one.obj", {"--frame", "0"});
  std::ofstream(files.path("a.xyz")) << "";
  using Words = std::vector<std::string>;
  const std::vector<std::tuple<std::string, std::string, Words, std::string>> table{
      {"run", "a.opj", {}, "files named '.opj' cannot be written; did you mean 'obj'?"},
      {"run", "a", {}, "known are: obj, ply, hair, data, vtp, pvd, usda, bin"},
      {"a.xyz", "a.obj", {}, "files named '.xyz' cannot be read; known are: data, hair, obj"},
      {"none.obj", "a.obj", {}, "there is no '"},
      {"run",
       "a.obj",
       {"--frame", "3"},
       "there is no frame of step 3; there are 3, of the steps 0"},
      {"run", "a.obj", {"--scale", "2"}, "is in metres"},
      {"one.obj", "a.ply", {"--scale", "0"}, "'--scale' expects a number > 0, found '0'"},
      {"one.obj", "a.ply", {"--radius", "1mm"}, "'--radius' expects a number > 0, found '1mm'"},
      {"run", "no/a.obj", {}, "is its folder there"},
      {"run", "a", {"--write", "odj"}, "there is no writer 'odj'; did you mean 'obj'?"},
      {"run", "a", {"--write", "{\"type\": \"obj\", \"evry\": 2}"}, "did you mean 'every'?"},
      {"run", "a", {"--write", "{\"type\""}, "expects the name of a writer or JSON"},
      {"run", "run", {"--write", "obj"}, "run' exists; expected a new folder"}};
  for (const auto& [in, out, options, reason] : table) {
    CAPTURE(in, out, options);
    CHECK_THAT(files.refusal(in, out, options), Catch::Contains(reason));
  }
  CHECK(files.names() == std::vector<std::string>{"a.xyz", "one.obj", "run"});
  const Workplace place;
  CHECK(place.run({"convert", files.path("run").string(), "a.opj"}).exit_code == 2);
}

TEST_CASE("units and radii that a file does not know may be given, bald spots are left out") {
  Converter files;
  std::ofstream(files.path("in.obj")) << "v 1 2 3\nv 4 5 6\nv 0 0 0\nl 3\nl 1 2\nl\n";
  files.convert("in.obj", "out.ply", {"--scale", "0.5", "--radius", "0.25"});
  const InputFrames frames = files.open("out.ply");
  CHECK(frames.vertex_counts == std::vector<int>{2});
  CHECK(frames.radii == std::vector<double>{0.25, 0.25});
  CHECK(frames.read(0).positions.col(1) == Eigen::Vector3d(2, 2.5, 3));
  std::ofstream(files.path("bald.obj")) << "v 1 2 3\nl 1\n";
  CHECK_THAT(files.refusal("bald.obj", "a.ply"), Catch::Contains("has 0 vertices of strands"));
}

TEST_CASE("any writer sees the frames of a run again, with velocities between them") {
  Converter files;
  files.convert("run", "seen/", {"--write", "witness"});
  CHECK(files.shown.steps == std::vector<int>{0, 2, 5});
  CHECK(files.shown.times[2] == Approx(0.5));
  CHECK(files.shown.first_velocities[0] == Eigen::Vector3d::Zero());
  CHECK(files.shown.first_velocities[2].z() == Approx(3).epsilon(1e-5));
  CHECK(files.shown.pins == 0);
  CHECK(fs::is_directory(files.path("seen")));
}

TEST_CASE("with a scene beside them, frames are written as the run would have written them") {
  const Workplace place;
  Json scene = small_scene();
  const Json late{"obj", "usda", {{"type", "ply"}, {"every", 4}}};
  scene["run"]["write"] = late;
  scene["run"]["write"].push_back("frames");
  place.write("scene.json", scene.dump());
  REQUIRE(place.run({"run", "scene.json", "-o", "run"}).exit_code == 0);
  for (const Json& writer : late) {
    const std::string name = writer.is_string() ? writer.get<std::string>() : "ply";
    const std::string text = writer.is_string() ? name : writer.dump();
    CAPTURE(text);
    REQUIRE(place.run({"convert", "run", name, "--write", text}).exit_code == 0);
    const bool is_sequence = name != "usda";
    const fs::path again = place.folder() / name / (is_sequence ? "frames" : "");
    const auto written = read_files(place.folder() / "run" / (is_sequence ? "frames" : ""));
    const auto files = read_files(again);
    CHECK(files.size() == (name == "obj" ? 7u : name == "ply" ? 3u : 1u));
    for (const auto& [file, bytes] : files) CHECK(written.at(file) == bytes);
  }

  Converter files;
  fs::copy(place.folder() / "run/scene.resolved.json", files.path("run"));
  CHECK_THAT(files.refusal("run", "a", {"--write", "witness"}),
             Catch::Contains("not those of scene.resolved.json"));
  fs::copy(place.folder() / "run", files.path("whole"), fs::copy_options::recursive);
  files.convert("whole", "seen", {"--write", "witness"});
  CHECK(files.shown.pins == 80);
}
