// Strands whose vertices stand in the scene itself.
#include <algorithm>

#include "core/registry.h"
#include "core/strand_source.h"

namespace ringlet {
namespace {

struct ListedStrand {
  std::vector<Eigen::Vector3d> vertices;
};

}  // namespace

template <>
struct Codec<ListedStrand> {
  static std::string type() { return "strand [[x, y, z], ...]"; }
  static Json schema(const KeyInfo& key) {
    Json schema = list_schema(vector_schema(key));
    schema["minItems"] = 2;
    return schema;
  }
  static void read(const Json& json, const std::string& pointer, const KeyInfo&,
                   ParseContext& context, ListedStrand& out) {
    if (!json.is_array() || json.size() < 2) {
      context.problem(pointer, "expected a strand of at least 2 vertices [[x, y, z], ...] in m" +
                                   (json.is_array() ? ", found " + std::to_string(json.size())
                                                    : std::string()));
      return;
    }
    const std::size_t problems = context.problems.size();
    std::vector<Eigen::Vector3d> vertices(json.size());
    KeyInfo vertex;
    vertex.type = "vertex [x, y, z]";
    vertex.unit = "m";
    for (std::size_t i = 0; i < json.size(); ++i) {
      Codec<Eigen::Vector3d>::read(json[i], pointer_to(pointer, i), vertex, context, vertices[i]);
      if (i > 0 && json[i] == json[i - 1]) {
        context.problem(pointer_to(pointer, i),
                        "expected a vertex apart from the one before it, found the same");
      }
    }
    if (context.problems.size() == problems) out.vertices = std::move(vertices);
  }
  static Json write(const ListedStrand& polyline) {
    return Codec<std::vector<Eigen::Vector3d>>::write(polyline.vertices);
  }
};

namespace {

struct Explicit {
  std::vector<ListedStrand> strands;
  int pinned = 2;
  MotionName motion;

  static Schema<Explicit> schema() {
    return Schema<Explicit>()
        .required("strands", &Explicit::strands, "m", any_number(),
                  "the vertices of each strand, root first")
        .key("pinned", &Explicit::pinned, "", at_least(0),
             "vertices of each strand, from the root, that are held")
        .key("motion", &Explicit::motion, "", any_number(),
             "name of the motion that the pinned vertices follow; empty: they rest")
        .check([](Explicit& source, const std::string& pointer, ParseContext& context) {
          if (!source.strands.empty()) return;
          context.problem(pointer_to(pointer, "strands"), "expected at least one strand");
        });
  }
};

class ExplicitSource final : public StrandSource {
 public:
  explicit ExplicitSource(const Explicit& source) : source_(source) {}

  StrandSet generate() const override {
    StrandSet set;
    for (const auto& [vertices] : source_.strands) {
      const int count = static_cast<int>(vertices.size());
      set.vertex_counts.push_back(count);
      set.pinned_counts.push_back(std::min(source_.pinned, count));
      set.motions.push_back(source_.motion.name);
      set.positions.insert(set.positions.end(), vertices.begin(), vertices.end());
    }
    return set;
  }

 private:
  Explicit source_;
};

}  // namespace

void register_explicit(Registry& registry) {
  registry.of<StrandSource>().add<Explicit>(
      "explicit", {"strands whose vertices stand in the scene", "", ""},
      [](const Explicit& source) { return std::make_unique<ExplicitSource>(source); });
}

}  // namespace ringlet
