// Polylines of a Wavefront .obj: vertices `v x y z`, m, and strands `l a b c ...`, whose indices
// count from 1, or edges `l a b`, `l b c`, ... The format has no place for radii.
#include <spdlog/fmt/fmt.h>

#include "core/registry.h"
#include "plugins/sequence_writer.h"

namespace ringlet {
namespace {

enum class ObjLines { polylines, edges };

struct ObjParameters {
  SequenceParameters sequence;
  ObjLines lines = ObjLines::polylines;

  static Schema<ObjParameters> schema();
};

void write_strand(int first, int end, ObjLines lines, std::ostream& stream) {
  if (lines == ObjLines::edges) {
    for (int v = first; v + 1 < end; ++v) stream << "l " << v + 1 << ' ' << v + 2 << '\n';
  } else {
    stream << 'l';
    for (int v = first; v < end; ++v) stream << ' ' << v + 1;
    stream << '\n';
  }
}

void write_obj(const Strands& strands, const State& state, ObjLines lines, std::ostream& stream) {
  stream << fmt::format("# ringlet: {} strands in m, +y up, at {} s\n", strands.count(),
                        state.time);
  for (int v = 0; v < strands.vertex_count(); ++v) {
    const Eigen::Vector3f x = state.positions.get(v).cast<float>();
    stream << fmt::format("v {} {} {}\n", x[0], x[1], x[2]);
  }
  for (int strand = 0; strand < strands.count(); ++strand) {
    write_strand(strands.first(strand), strands.first(strand + 1), lines, stream);
  }
}

}  // namespace

template <>
struct EnumNames<ObjLines> {
  static constexpr std::pair<ObjLines, const char*> names[] = {{ObjLines::polylines, "polylines"},
                                                               {ObjLines::edges, "edges"}};
};

namespace {

Schema<ObjParameters> ObjParameters::schema() {
  return Schema<ObjParameters>()
      .include(&ObjParameters::sequence)
      .key("lines", &ObjParameters::lines, "", any_number(),
           "a polyline a strand, or each edge by itself, for programs that see but the first edge "
           "of a polyline, as Blender 3's importer");
}

}  // namespace

void register_obj(Registry& registry);
void register_obj(Registry& registry) {
  registry.of<Observer>().add<ObjParameters>(
      "obj", {"polylines of Wavefront's format: frames/frame_<step>.obj", "", ""},
      [](const ObjParameters& parameters) {
        return std::make_unique<SequenceWriter>(
            "obj", parameters.sequence,
            [lines = parameters.lines](const Strands& strands, const State& state,
                                       std::ostream& stream) {
              write_obj(strands, state, lines, stream);
            });
      });
}

}  // namespace ringlet
