#include <unistd.h>

#include <fstream>
#include <sstream>

#include "core/registry.h"
#include "plugins/modules.h"
#include "plugins/vtp/vtp_format.h"
#include "plugins/vtp/vtp_reader.h"
#include "plugins/vtp/vtp_writer.h"
#include "tests/catch.h"
#include "tests/plugins/vtp/read_vtp.h"
#include "tests/temporary_file.h"

using namespace ringlet;
namespace fs = std::filesystem;

namespace {

/// Strands of 2, 5 and 3 vertices with coordinates and velocities that are all different.
struct Sample {
  Sample() : model(make_strands()) {
    std::vector<Eigen::Vector3d> positions;
    state.velocities = VertexField(model.groups);
    for (int v = 0; v < 10; ++v) {
      positions.push_back(model.strands.rest_position(v) + Eigen::Vector3d(0.1, 0.2, 1e-3 * v));
      state.velocities.set(v, {-1.0 * v, 1.0 / (v + 1), 0.25});
    }
    state.positions = positions_with_pads(model.groups, positions);
    state.time = 0.7;
  }

  static Strands make_strands() {
    std::vector<Eigen::Vector3d> rest;
    for (int v = 0; v < 10; ++v) rest.emplace_back(0.01 * v, 0.001 * v * v, 0);
    Material material;
    material.radius = 2e-3;
    material.tip_radius = 1e-3;
    return Strands({2, 5, 3}, rest, material);
  }

  Model model;
  State state;
};

void check_content(const VtpContent& content, const Sample& sample) {
  CHECK(content.points == 10);
  CHECK(content.lines == 3);
  CHECK(content.time == 0.7);
  REQUIRE(content.arrays.size() == 6);
  CHECK(content.arrays.at("strand") == std::vector<double>{0, 0, 1, 1, 1, 1, 1, 2, 2, 2});
  CHECK(content.arrays.at("connectivity") == std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  CHECK(content.arrays.at("offsets") == std::vector<double>{2, 7, 10});
  const auto& points = content.arrays.at("Points");
  const auto& velocity = content.arrays.at("velocity");
  const auto& radius = content.arrays.at("radius");
  REQUIRE((points.size() == 30 && velocity.size() == 30 && radius.size() == 10));
  for (int v = 0; v < 10; ++v) {
    CHECK(radius[v] == Approx(sample.model.strands.radius(v)).epsilon(1e-6));
    for (int c = 0; c < 3; ++c) {
      CHECK(points[3 * v + c] == Approx(sample.state.positions.get(v)[c]).epsilon(1e-6));
      CHECK(velocity[3 * v + c] == Approx(sample.state.velocities.get(v)[c]).epsilon(1e-6));
    }
  }
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string written(const Sample& sample, VtpEncoding encoding) {
  std::ostringstream stream;
  write_vtp(sample.model.strands, sample.state, encoding, stream);
  return stream.str();
}

}  // namespace

TEST_CASE("a .vtp file holds the state, in both encodings, and always the same bytes") {
  const Sample sample;
  for (const VtpEncoding encoding : {VtpEncoding::binary, VtpEncoding::ascii}) {
    const std::string bytes = written(sample, encoding);
    check_content(read_vtp(bytes), sample);
    CHECK(bytes == written(Sample(), encoding));
  }
}

TEST_CASE("the writer writes every so many steps, and the first and the last state") {
  const fs::path folder = fs::temp_directory_path() / ("ringlet_vtp_" + std::to_string(getpid()));
  const Sample sample;
  VtpParameters parameters;
  parameters.every = 3;
  VtpWriter writer(parameters);
  fs::create_directory(folder);
  writer.begin(sample.model, sample.state, folder);
  CHECK(read_text(folder / "run.pvd").find("</VTKFile>") != std::string::npos);
  for (int step = 1; step <= 7; ++step) writer.observe(sample.model, sample.state, step, {});
  writer.end(sample.model, sample.state, 7);

  const std::string index = read_text(folder / "run.pvd");
  std::size_t last = 0;
  for (const char* number : {"00000", "00003", "00006", "00007"}) {
    const std::string name = std::string("frames/frame_") + number + ".vtp";
    CHECK(fs::exists(folder / name));
    const std::size_t at = index.find("timestep=\"0.7\" part=\"0\" file=\"" + name + "\"", last);
    CHECK(at != std::string::npos);
    last = at;
  }
  CHECK(std::distance(fs::directory_iterator(folder / "frames"), {}) == 4);
  check_content(read_vtp(read_text(folder / "frames/frame_00007.vtp")), sample);
  fs::remove_all(folder);
}

TEST_CASE("a last state that was already written is not written twice") {
  const fs::path folder = fs::temp_directory_path() / ("ringlet_vtp_" + std::to_string(getpid()));
  const Sample sample;
  VtpWriter writer({});
  writer.begin(sample.model, sample.state, folder);
  writer.observe(sample.model, sample.state, 1, {});
  writer.end(sample.model, sample.state, 1);
  const std::string index = read_text(folder / "run.pvd");
  CHECK(index.find("frame_00001") == index.rfind("frame_00001"));
  fs::remove_all(folder);
}

TEST_CASE("a frame is read back as it was written, in both encodings") {
  const Sample sample;
  for (const VtpEncoding encoding : {VtpEncoding::binary, VtpEncoding::ascii}) {
    const TemporaryFile file("vtp", written(sample, encoding));
    const VtpFrame frame = read_vtp_frame(file.path());
    CHECK(frame.time == 0.7);
    CHECK(frame.offsets == std::vector<std::int32_t>{2, 7, 10});
    REQUIRE((frame.points.size() == 30 && frame.radii.size() == 10));
    for (int v = 0; v < 10; ++v) {
      CHECK(frame.radii[v] == Approx(sample.model.strands.radius(v)).epsilon(1e-6));
      for (int c = 0; c < 3; ++c) {
        CHECK(frame.points[3 * v + c] == Approx(sample.state.positions.get(v)[c]).epsilon(1e-6));
      }
    }
  }
}

TEST_CASE("a frame that is not whole is refused, wherever it ends") {
  const std::string whole = written(Sample(), VtpEncoding::binary);
  for (std::size_t size = 0; size < whole.size() - 1; size += 7) {
    const TemporaryFile file("vtp", whole.substr(0, size));
    CHECK_THROWS_AS(read_vtp_frame(file.path()), Error);
  }
  CHECK_THROWS_AS(read_vtp_frame("no/such/file.vtp"), Error);
}

TEST_CASE("a frame whose arrays do not fit together is refused") {
  const std::string whole = written(Sample(), VtpEncoding::ascii);
  for (const auto& [from, to] : {std::pair{"2 7 10", "2 7 11"}, std::pair{"2 7 10", "7 2 10"},
                                 std::pair{"Name=\"Points\"", "Name=\"Other\""}}) {
    std::string text = whole;
    REQUIRE(text.find(from) != std::string::npos);
    text.replace(text.find(from), std::string(from).size(), to);
    const TemporaryFile file("vtp", text);
    CHECK_THROWS_AS(read_vtp_frame(file.path()), Error);
  }
}

TEST_CASE("the module makes vtp known, with its keys") {
  Registry registry;
  register_plugins(registry);
  const auto* entry = registry.of<Observer>().find("vtp");
  REQUIRE(entry != nullptr);
  CHECK(entry->keys.size() == 2);
}
