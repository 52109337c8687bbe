#include "core/registry.h"
#include "plugins/frames/frames_writer.h"

namespace ringlet {

void register_frames(Registry& registry);
void register_frames(Registry& registry) {
  registry.of<Observer>().add<FramesParameters>(
      "frames",
      {"all frames in one compact binary file, frames.bin, whole however a run ends", "", ""},
      [](const FramesParameters& parameters) {
        return std::make_unique<FramesWriter>(parameters);
      });
}

}  // namespace ringlet
