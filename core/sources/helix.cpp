// Helices. With h = pitch / segments_per_turn and phi = 2 pi / segments_per_turn, vertex k of the
// helix is (r cos(k phi), k h, -r sin(k phi)): right-handed about +y. All its edges are equal, of
// length sqrt((2 r sin(phi/2))^2 + h^2).
// Source: the wisp "type 4C" of Shi, Wu, Parr, Darke, Kim, "Lifted Curls", SCA 2023.
#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>

#include "core/sources/rooted_strands.h"

namespace ringlet {

enum class Handedness { right, left };

template <>
struct EnumNames<Handedness> {
  static constexpr std::pair<Handedness, const char*> names[] = {{Handedness::right, "right"},
                                                                 {Handedness::left, "left"}};
};

namespace {

struct Helix {
  RootedStrands strands;
  double curl_radius = 0.005;
  double pitch = 0.005;
  double segments_per_turn = 5;
  Handedness handedness = Handedness::right;
  int stem_vertices = 0;
  double stem_spacing = 0.01;
  bool random_turn = false;

  static Schema<Helix> schema() {
    return Schema<Helix>()
        .include(&Helix::strands)
        .key("curl_radius", &Helix::curl_radius, "m", positive(),
             "radius of the helix; its axis passes through the root")
        .key("pitch", &Helix::pitch, "m", positive(), "height of one turn")
        .key("segments_per_turn", &Helix::segments_per_turn, "",
             Range{.low = 2, .low_excluded = true}, "edges of one turn; need not be whole")
        .key("handedness", &Helix::handedness, "", any_number(),
             "whether it turns like a right-handed screw or a left-handed one")
        .key("stem_vertices", &Helix::stem_vertices, "", at_least(0),
             "vertices of a straight stem, parallel to the axis, that rises from the root to the "
             "helix; its last vertex is the first of the helix")
        .key("stem_spacing", &Helix::stem_spacing, "m", positive(), "length of an edge of the stem")
        .key("random_turn", &Helix::random_turn, "", any_number(),
             "whether each strand is turned about its own axis by a random angle")
        .check([](Helix& helix, const std::string& pointer, ParseContext& context) {
          if (helix.stem_vertices < helix.strands.vertices) return;
          context.problem(pointer_to(pointer, "stem_vertices"),
                          "expected fewer than the " + std::to_string(helix.strands.vertices) +
                              " vertices of a strand, found " +
                              std::to_string(helix.stem_vertices));
        });
  }
};

class HelixSource final : public StrandSource {
 public:
  explicit HelixSource(const Helix& helix) : helix_(helix) {}

  StrandSet generate() const override {
    const int stem_edges = std::max(helix_.stem_vertices - 1, 0);
    std::vector<Eigen::Vector3d> shape;
    for (int i = 0; i < helix_.strands.vertices; ++i) {
      const double height = std::min(i, stem_edges) * helix_.stem_spacing;
      shape.push_back(curl(std::max(i - stem_edges, 0)) + height * Eigen::Vector3d::UnitY());
    }
    return grow_strands(helix_.strands, shape, helix_.random_turn ? Turn::random : Turn::none);
  }

 private:
  Eigen::Vector3d curl(int k) const {
    const double sense = helix_.handedness == Handedness::right ? 1 : -1;
    const double angle = sense * 2 * std::numbers::pi * k / helix_.segments_per_turn;
    return {helix_.curl_radius * std::cos(angle), helix_.pitch * k / helix_.segments_per_turn,
            -helix_.curl_radius * std::sin(angle)};
  }

  Helix helix_;
};

}  // namespace

void register_helix(Registry& registry) {
  registry.of<StrandSource>().add<Helix>(
      "helix",
      {"curls: helices of equal edges, with a straight stem at the root if wanted",
       "x_k = (r cos(k phi), k h, -r sin(k phi)), phi = 2 pi / segments_per_turn, h = pitch / "
       "segments_per_turn",
       "Shi et al., Lifted Curls, SCA 2023"},
      [](const Helix& helix) { return std::make_unique<HelixSource>(helix); });
}

}  // namespace ringlet
