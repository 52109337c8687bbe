// Polylines of a Wavefront .obj: vertices `v x y z`, m, and strands `l a b c ...`, whose indices
// count from 1. The format has no place for radii.
#include <spdlog/fmt/fmt.h>

#include "core/registry.h"
#include "plugins/sequence_writer.h"

namespace ringlet {
namespace {

void write_obj(const Strands& strands, const State& state, std::ostream& stream) {
  stream << fmt::format("# ringlet: {} strands in m, +y up, at {} s\n", strands.count(),
                        state.time);
  for (int v = 0; v < strands.vertex_count(); ++v) {
    const Eigen::Vector3f x = state.positions.get(v).cast<float>();
    stream << fmt::format("v {} {} {}\n", x[0], x[1], x[2]);
  }
  for (int strand = 0; strand < strands.count(); ++strand) {
    stream << 'l';
    for (int v = strands.first(strand); v < strands.first(strand + 1); ++v) stream << ' ' << v + 1;
    stream << '\n';
  }
}

}  // namespace

void register_obj(Registry& registry);
void register_obj(Registry& registry) {
  registry.of<Observer>().add<SequenceParameters>(
      "obj", {"polylines of Wavefront's format: frames/frame_<step>.obj", "", ""},
      [](const SequenceParameters& parameters) {
        return std::make_unique<SequenceWriter>("obj", parameters, write_obj);
      });
}

}  // namespace ringlet
