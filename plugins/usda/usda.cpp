#include "core/registry.h"
#include "core/strand_reader.h"
#include "plugins/usda/usda_reader.h"
#include "plugins/usda/usda_writer.h"

namespace ringlet {
namespace {

const char* const usda_source = "OpenUSD, UsdGeomBasisCurves";

/// The first time sample of a .usda file.
class UsdaStrands final : public StrandReader {
 public:
  Polylines read(const std::filesystem::path& file) const override {
    UsdaReader reader(file);
    const Eigen::Matrix3Xd x = reader.read(0);
    Polylines polylines{reader.vertex_counts(), {}, reader.radii()};
    for (Eigen::Index v = 0; v < x.cols(); ++v) polylines.positions.emplace_back(x.col(v));
    return polylines;
  }
};

}  // namespace

void register_usda(Registry& registry);
void register_usda(Registry& registry) {
  registry.of<Observer>().add<UsdaParameters>(
      "usda", {"curves with time samples for Houdini, Blender, Maya: run.usda", "", usda_source},
      [](const UsdaParameters& parameters) { return std::make_unique<UsdaWriter>(parameters); });
  registry.of<StrandReader>().add<NoParameters>(
      "usda", {"linear curves of a .usda, in metres, of the first time sample", "", usda_source},
      [](const NoParameters&) { return std::make_unique<UsdaStrands>(); });
}

}  // namespace ringlet
