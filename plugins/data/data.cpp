// The .data format of USC-HairSalon, little endian: i32 number of strands; for each of them i32
// number of vertices and f32 coordinates of each, m.
#include <cstdint>

#include "core/registry.h"
#include "plugins/little_endian.h"
#include "plugins/sequence_writer.h"

namespace ringlet {
namespace {

void write_data(const Strands& strands, const State& state, std::ostream& stream) {
  put(stream, std::int32_t{strands.count()});
  for (int strand = 0; strand < strands.count(); ++strand) {
    put(stream, std::int32_t{strands.size(strand)});
    for (int v = strands.first(strand); v < strands.first(strand + 1); ++v) {
      put_point(stream, state.positions.get(v));
    }
  }
}

}  // namespace

void register_data(Registry& registry);
void register_data(Registry& registry) {
  registry.of<Observer>().add<SequenceParameters>(
      "data",
      {"USC-HairSalon's format: frames/frame_<step>.data", "",
       "Hu et al., Single-View Hair Modeling Using a Hairstyle Database, SIGGRAPH 2015"},
      [](const SequenceParameters& parameters) {
        return std::make_unique<SequenceWriter>("data", parameters, write_data);
      });
}

}  // namespace ringlet
