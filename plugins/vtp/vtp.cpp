#include "core/observer.h"
#include "core/registry.h"
#include "plugins/vtp/vtp_writer.h"

namespace ringlet {

void register_vtp(Registry& registry);
void register_vtp(Registry& registry) {
  registry.of<Observer>().add<VtpParameters>(
      "vtp",
      {"polylines for ParaView: frames/frame_<step>.vtp and their index run.pvd", "",
       "VTK file formats, XML PolyData"},
      [](const VtpParameters& parameters) { return std::make_unique<VtpWriter>(parameters); });
}

}  // namespace ringlet
