#include "core/registry.h"
#include "plugins/ply/ply_format.h"
#include "plugins/ply/ply_reader.h"
#include "plugins/sequence_writer.h"

namespace ringlet {
namespace {

struct PlyParameters {
  SequenceParameters sequence;
  PlyEncoding encoding = PlyEncoding::binary;

  static Schema<PlyParameters> schema() {
    return Schema<PlyParameters>()
        .include(&PlyParameters::sequence)
        .key("encoding", &PlyParameters::encoding, "", any_number(),
             "of the numbers: binary is small and quick; ascii can be read by eye");
  }
};

const char* const ply_source = "G. Turk, The PLY Polygon File Format, 1994";

}  // namespace

void register_ply(Registry& registry);
void register_ply(Registry& registry) {
  registry.of<Observer>().add<PlyParameters>(
      "ply", {"vertices and edges of Turk's format: frames/frame_<step>.ply", "", ply_source},
      [](const PlyParameters& parameters) {
        return std::make_unique<SequenceWriter>(
            "ply", parameters.sequence,
            [encoding = parameters.encoding](const Strands& strands, const State& state,
                                             std::ostream& stream) {
              write_ply(strands, state, encoding, stream);
            });
      });
  registry.of<StrandReader>().add<NoParameters>(
      "ply", {"vertices and edges of a .ply, text or little endian", "", ply_source},
      [](const NoParameters&) { return std::make_unique<PlyReader>(); });
}

}  // namespace ringlet
