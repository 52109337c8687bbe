#include "core/registry.h"
#include "core/strand_reader.h"
#include "plugins/vtp/vtp_reader.h"
#include "plugins/vtp/vtp_writer.h"

namespace ringlet {
namespace {

const char* const vtp_source = "VTK file formats, XML PolyData";

class VtpStrands final : public StrandReader {
 public:
  Polylines read(const std::filesystem::path& file) const override {
    const VtpFrame frame = read_vtp_frame(file);
    Polylines polylines;
    polylines.radii.assign(frame.radii.begin(), frame.radii.end());
    int first = 0;
    for (const int end : frame.offsets) {
      polylines.vertex_counts.push_back(end - first);
      first = end;
    }
    for (std::size_t i = 0; i + 2 < frame.points.size(); i += 3) {
      polylines.positions.push_back(Eigen::Vector3f(&frame.points[i]).cast<double>());
    }
    return polylines;
  }
};

}  // namespace

void register_vtp(Registry& registry);
void register_vtp(Registry& registry) {
  registry.of<Observer>().add<VtpParameters>(
      "vtp",
      {"polylines for ParaView: frames/frame_<step>.vtp and their index run.pvd", "", vtp_source},
      [](const VtpParameters& parameters) { return std::make_unique<VtpWriter>(parameters); });
  registry.of<StrandReader>().add<NoParameters>(
      "vtp", {"polylines of a .vtp that ringlet wrote", "", vtp_source},
      [](const NoParameters&) { return std::make_unique<VtpStrands>(); });
}

}  // namespace ringlet
