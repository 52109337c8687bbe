// Roots at one point, or side by side on a line.
#include "core/direction.h"
#include "core/registry.h"
#include "core/strand_source.h"

namespace ringlet {
namespace {

struct Point {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Direction direction;

  static Schema<Point> schema() {
    return Schema<Point>()
        .key("position", &Point::position, "m", any_number(), "of the first root")
        .key("direction", &Point::direction, "", any_number(), "in which the strands grow");
  }
};

struct Row {
  Point first;
  Eigen::Vector3d spacing = {0.01, 0, 0};

  static Schema<Row> schema() {
    return Schema<Row>()
        .include(&Row::first)
        .key("spacing", &Row::spacing, "m", any_number(), "vector from each root to the next");
  }
};

class RowRoots final : public RootSource {
 public:
  explicit RowRoots(const Row& row) : row_(row) {}

  std::vector<Root> place(int count, unsigned) const override {
    std::vector<Root> roots;
    for (int i = 0; i < count; ++i) {
      roots.push_back({row_.first.position + i * row_.spacing, row_.first.direction.unit});
    }
    return roots;
  }

 private:
  Row row_;
};

}  // namespace

void register_row_roots(Registry& registry) {
  registry.of<RootSource>().add<Point>(
      "point", {"all strands at one point", "", ""}, [](const Point& point) {
        return std::make_unique<RowRoots>(Row{point, Eigen::Vector3d::Zero()});
      });
  registry.of<RootSource>().add<Row>(
      "row", {"strands side by side on a line", "root i = position + i spacing", ""},
      [](const Row& row) { return std::make_unique<RowRoots>(row); });
}

}  // namespace ringlet
