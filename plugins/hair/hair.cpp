// The .hair format of Cem Yuksel, little endian: a header of 128 bytes; u16 segments of each
// strand; f32 points, m; f32 thickness at each point, which is the diameter, m. Source:
// http://www.cemyuksel.com/research/hairmodels
#include <cstdint>
#include <limits>

#include "core/registry.h"
#include "plugins/little_endian.h"
#include "plugins/sequence_writer.h"

namespace ringlet {
namespace {

constexpr int most_segments = std::numeric_limits<std::uint16_t>::max();
constexpr std::uint32_t has_segments = 1, has_points = 2, has_thickness = 4;

float thickness(const Strands& strands, int vertex) {
  return 2 * static_cast<float>(strands.radius(vertex));
}

void write_header(const Strands& strands, std::ostream& stream) {
  stream << "HAIR";
  put(stream, static_cast<std::uint32_t>(strands.count()));
  put(stream, static_cast<std::uint32_t>(strands.vertex_count()));
  put(stream, has_segments | has_points | has_thickness);
  put(stream, static_cast<std::uint32_t>(strands.size(0) - 1));
  put(stream, thickness(strands, 0));
  put(stream, 0.0f);                              // transparency
  for (int c = 0; c < 3; ++c) put(stream, 0.5f);  // colour
  std::string note = "strands of ringlet in m, +y up";
  note.resize(88);
  stream << note;
}

void write_hair(const Strands& strands, const State& state, std::ostream& stream) {
  write_header(strands, stream);
  for (int strand = 0; strand < strands.count(); ++strand) {
    const int segments = strands.size(strand) - 1;
    if (segments > most_segments) {
      throw Error("strand " + std::to_string(strand) + " has " + std::to_string(segments) +
                  " segments; a strand of a .hair file has at most " +
                  std::to_string(most_segments));
    }
    put(stream, static_cast<std::uint16_t>(segments));
  }
  for (int v = 0; v < strands.vertex_count(); ++v) put_point(stream, state.positions.get(v));
  for (int v = 0; v < strands.vertex_count(); ++v) put(stream, thickness(strands, v));
}

}  // namespace

void register_hair(Registry& registry);
void register_hair(Registry& registry) {
  registry.of<Observer>().add<SequenceParameters>(
      "hair",
      {"Cem Yuksel's format: frames/frame_<step>.hair", "",
       "http://www.cemyuksel.com/research/hairmodels"},
      [](const SequenceParameters& parameters) {
        return std::make_unique<SequenceWriter>("hair", parameters, write_hair);
      });
}

}  // namespace ringlet
