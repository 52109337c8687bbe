#pragma once

#include <fstream>
#include <iterator>
#include <memory>

#include "core/modules.h"
#include "core/observer.h"
#include "core/registry.h"
#include "core/strand_reader.h"
#include "plugins/modules.h"
#include "tests/catch.h"
#include "tests/temporary_file.h"
#include "tests/temporary_folder.h"

namespace ringlet {

/// A plugin of core or plugins/ as a scene would choose it. Throws InvalidInput.
template <class Interface>
std::unique_ptr<Interface> make_of_plugins(const Json& json) {
  Registry registry;
  register_core(registry);
  register_plugins(registry);
  std::vector<Problem> problems;
  ParseContext context{registry, std::filesystem::current_path(), {}, problems};
  Choice<Interface> choice;
  Codec<Choice<Interface>>::read(json, "", {}, context, choice);
  if (!problems.empty()) throw InvalidInput(problems);
  return choice.make();
}

/// States 0, 1, ... of tapered strands of 2 and 3 vertices, as a writer sees them. All coordinates
/// are 32-bit floats.
class WrittenRun {
 public:
  explicit WrittenRun(const Json& choice)
      : model(make_strands()),
        state{0, positions_with_pads(model.groups, rest()), VertexField(model.groups)},
        writer(make_of_plugins<Observer>(choice)) {
    writer->begin(model, state, folder.path());
  }

  void steps(int first, int last) {
    for (int step = first; step <= last; ++step) {
      go_to(step);
      writer->observe(model, state, step, {});
    }
  }
  /// Another writer goes on after a step, in the same folder.
  void resume(const Json& choice, int step) {
    go_to(step);
    writer = make_of_plugins<Observer>(choice);
    writer->resume(model, state, folder.path(), step);
  }
  void end(int step) { writer->end(model, state, step); }

  /// Whether strands are those of a step; with other radii only if the file has none.
  void check(const Polylines& read, int step) const {
    CHECK(read.vertex_counts == std::vector<int>{2, 3});
    REQUIRE(read.positions.size() == 5);
    for (int v = 0; v < 5; ++v) {
      const Eigen::Vector3d expected = position(v, step);
      CHECK(read.positions[static_cast<std::size_t>(v)].cast<float>() == expected.cast<float>());
    }
    if (read.radii.empty()) return;
    REQUIRE(read.radii.size() == 5);
    for (int v = 0; v < 5; ++v) {
      CHECK(static_cast<float>(read.radii[static_cast<std::size_t>(v)]) ==
            static_cast<float>(model.strands.radius(v)));
    }
  }

  static Eigen::Vector3d position(int vertex, int step) {
    return {vertex / 7.0, 1e-3 * vertex * vertex - step / 3.0, vertex == 4 ? 1e-7 * step : 5};
  }
  static double time(int step) { return 0.1 * step; }

  TemporaryFolder folder;
  Model model;
  State state;
  std::unique_ptr<Observer> writer;

 private:
  static std::vector<Eigen::Vector3d> rest() {
    std::vector<Eigen::Vector3d> positions;
    for (int v = 0; v < 5; ++v) positions.push_back(position(v, 0));
    return positions;
  }
  static Strands make_strands() {
    Material material;
    material.radius = 2e-3;
    material.tip_radius = 1e-3;
    return Strands({2, 3}, rest(), material);
  }
  void go_to(int step) {
    state.time = time(step);
    for (int v = 0; v < 5; ++v) state.positions.set(v, position(v, step));
  }
};

inline std::string bytes_in(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What the reader of a file's extension makes of it.
inline Polylines read_strands(const std::filesystem::path& path) {
  return make_of_plugins<StrandReader>(path.extension().string().substr(1))->read(path);
}

/// Why some bytes are refused as a file of an extension; "" if strands are read.
inline std::string reason_against(const std::string& extension, const std::string& bytes) {
  const TemporaryFile file(extension, bytes);
  try {
    const Polylines read = read_strands(file.path());
    std::size_t vertices = 0;
    for (const int count : read.vertex_counts) vertices += static_cast<std::size_t>(count);
    REQUIRE(vertices == read.positions.size());
    REQUIRE((read.radii.empty() || read.radii.size() == vertices));
    for (const auto& position : read.positions) REQUIRE(position.allFinite());
    return "";
  } catch (const Error& error) {
    return error.what();
  }
}

/// Feeds a reader every version of a file that is cut or has a wrong byte: all must be read to
/// finite strands, or refused with an Error.
inline void damage_everywhere(const std::string& extension, const std::string& whole) {
  for (std::size_t i = 0; i < whole.size(); ++i) {
    reason_against(extension, whole.substr(0, i));
    for (const char value : {'\x00', '\x7f', '\xff', '-', '9', ']'}) {
      reason_against(extension, std::string(whole).replace(i, 1, 1, value));
    }
  }
}

}  // namespace ringlet
