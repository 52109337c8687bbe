// Straight strands: vertex k stands at height k length / (vertices - 1) above the root.
#include "core/sources/rooted_strands.h"

namespace ringlet {
namespace {

struct Line {
  RootedStrands strands;
  double length = 0.1;

  static Schema<Line> schema() {
    return Schema<Line>()
        .include(&Line::strands)
        .key("length", &Line::length, "m", positive(), "of each strand");
  }
};

class LineSource final : public StrandSource {
 public:
  explicit LineSource(const Line& line) : line_(line) {}

  StrandSet generate() const override {
    const int edges = line_.strands.vertices - 1;
    std::vector<Eigen::Vector3d> shape;
    for (int k = 0; k <= edges; ++k) {
      shape.push_back(line_.length * k / edges * Eigen::Vector3d::UnitY());
    }
    return grow_strands(line_.strands, shape, Turn::none);
  }

 private:
  Line line_;
};

}  // namespace

void register_line(Registry& registry) {
  registry.of<StrandSource>().add<Line>(
      "line", {"straight strands", "x_k = (0, k length / (vertices - 1), 0)", ""},
      [](const Line& line) { return std::make_unique<LineSource>(line); });
}

}  // namespace ringlet
