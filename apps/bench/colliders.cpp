// What it costs to find the vertices of the hairball that are near a head: a pass over all of them,
// as the collision stage makes it, for each kind of head.

#include <spdlog/fmt/fmt.h>

#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>

#include "apps/bench/bench.h"
#include "apps/bench/hairball.h"
#include "collision/collider_contacts.h"
#include "core/read_choice.h"

namespace ringlet {
namespace {

constexpr double head_radius = 0.1525;

/// A ball with bumps, of 5,000 triangles, in a file that lasts as long as this.
class BumpyHead {
 public:
  static constexpr int around = 50, rings = 50;  // vertices of a ring; rings between the poles
  static constexpr int triangles = 2 * around * rings;

  explicit BumpyHead(double radius)
      : path_(std::filesystem::temp_directory_path() /
              ("ringlet_bench_" + std::to_string(std::random_device()()) + ".obj")) {
    std::ofstream file(path_);
    for (int ring = 0; ring <= rings + 1; ++ring) {
      for (int i = 0; i < (is_pole(ring) ? 1 : around); ++i) write_vertex(file, radius, ring, i);
    }
    for (int ring = 0; ring <= rings; ++ring) {
      for (int i = 0; i < around; ++i) write_triangles(file, ring, i);
    }
  }
  ~BumpyHead() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  BumpyHead(const BumpyHead&) = delete;
  BumpyHead& operator=(const BumpyHead&) = delete;

  std::string file() const { return path_.string(); }

 private:
  static bool is_pole(int ring) { return ring == 0 || ring == rings + 1; }
  /// Numbers begin with 1.
  static int number(int ring, int i) {
    if (ring == 0) return 1;
    return is_pole(ring) ? 2 + rings * around : 2 + (ring - 1) * around + i % around;
  }
  static void write_vertex(std::ofstream& file, double radius, int ring, int i) {
    const double down = std::numbers::pi * ring / (rings + 1);
    const double turn = 2 * std::numbers::pi * i / around;
    const double r = radius * (1 - 0.02 * std::pow(std::sin(down) * std::cos(3 * turn), 2));
    file << "v " << r * std::sin(down) * std::cos(turn) << ' ' << r * std::cos(down) << ' '
         << r * std::sin(down) * std::sin(turn) << '\n';
  }
  static void write_triangles(std::ofstream& file, int ring, int i) {
    const int a = number(ring, i), b = number(ring, i + 1);
    const int c = number(ring + 1, i), d = number(ring + 1, i + 1);
    if (ring > 0) file << "f " << a << ' ' << b << ' ' << d << '\n';
    if (ring < rings) file << "f " << a << ' ' << d << ' ' << c << '\n';
  }

  std::filesystem::path path_;
};

using PointList = std::vector<Eigen::Vector3d>;

/// The vertices of the hairball standing on the head, or, with all that sticks out scaled down so
/// far that none is more than a centimetre away, lying on it.
PointList positions_of(const Strands& strands, bool lying) {
  PointList positions;
  double farthest = 0;
  for (int v = 0; v < strands.vertex_count(); ++v) {
    positions.push_back(strands.rest_position(v));
    farthest = std::max(farthest, positions.back().norm());
  }
  const double scale = lying ? 0.01 / (farthest - head_radius) : 1;
  for (auto& p : positions) p *= (head_radius + scale * (p.norm() - head_radius)) / p.norm();
  return positions;
}

BenchRow measure_collider(const Registry& registry, const Simulation& simulation, bool lying,
                          const Json& choice, const BenchOptions& options) {
  constexpr double reach = 1e-3;
  const Strands& strands = simulation.model().strands;
  const PointList positions = positions_of(strands, lying);
  const std::vector<EdgeChunk> chunks = make_edge_chunks(strands);
  std::vector<std::unique_ptr<Collider>> colliders;
  colliders.push_back(make_chosen<Collider>(registry, choice));
  ColliderContacts contacts(std::move(colliders), {nullptr, reach, 0}, 0);
  contacts.bind(chunks, simulation.model().motions);
  contacts.set_free(std::vector<bool>(positions.size(), true));
  Timing time{};
  with_threads(options.threads,
               [&] { time = measure([&] { contacts.detect(positions); }, options.seconds); });
  return {.name = "collider",
          .parameters = {{"collider", choice["type"]},
                         {"hair", lying ? "lying" : "standing"},
                         {"vertices", positions.size()},
                         {"threads", options.threads}},
          .time = time,
          .contacts = contacts.candidate_count()};
}

}  // namespace

void bench_colliders(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  constexpr double milli = 1e-3;
  const Json scene = hairball_without_contacts(options.strands_or(2000));
  const Simulation simulation(read_scene(scene, registry, "."));
  const BumpyHead head(head_radius);
  output.start_table(
      fmt::format("Colliders: vertices of the hairball nearer than 1 mm to a head (of {} "
                  "triangles, where it is a mesh), the hair standing as it does or lying within 1 "
                  "cm, {} threads",
                  BumpyHead::triangles, options.threads),
      {{"collider", "/parameters/collider"},
       {"hair", "/parameters/hair"},
       {"vertices", "/parameters/vertices"},
       {"near", "/contacts"},
       {"a pass, ms", "/seconds", milli},
       {"spread", "/spread", milli}});
  for (const bool lying : {false, true}) {
    for (const Json& choice : {Json{{"type", "sphere"}, {"radius", head_radius}},
                               Json{{"type", "mesh"}, {"path", head.file()}},
                               Json{{"type", "sdf"}, {"path", head.file()}}}) {
      output.add(measure_collider(registry, simulation, lying, choice, options));
    }
  }
}

}  // namespace ringlet
