// The .data format of USC-HairSalon. Little endian: i32 number of strands; for each of them i32
// number of vertices and f32 coordinates of each vertex. One vertex stands for a bald spot.
// Source: L. Hu et al., Single-View Hair Modeling Using a Hairstyle Database, SIGGRAPH 2015.
#include "core/readers/file_bytes.h"
#include "core/registry.h"
#include "core/strand_reader.h"

namespace ringlet {
namespace {

// A count of things that take at least so many bytes each.
int take_count(FileBytes& bytes, std::uint64_t bytes_each, const std::string& what) {
  const auto count = bytes.take<std::int32_t>("number of " + what);
  if (count < 0) bytes.fail("expected a number of " + what + ", found " + std::to_string(count));
  bytes.require(bytes_each * static_cast<std::uint64_t>(count), std::to_string(count) + " " + what);
  return count;
}

class DataReader final : public StrandReader {
 public:
  Polylines read(const std::filesystem::path& file) const override {
    FileBytes bytes(file);
    Polylines polylines;
    const int strands = take_count(bytes, sizeof(std::int32_t), "strands");
    for (int strand = 0; strand < strands; ++strand) {
      const int vertices = take_count(bytes, 3 * sizeof(float), "vertices");
      polylines.vertex_counts.push_back(vertices);
      for (int i = 0; i < vertices; ++i) polylines.positions.push_back(bytes.take_point());
    }
    if (bytes.left() > 0) {
      bytes.fail("expected the end of the file after " + std::to_string(strands) +
                 " strands, found " + std::to_string(bytes.left()) + " bytes more");
    }
    return polylines;
  }
};

}  // namespace

void register_data_reader(Registry& registry) {
  registry.of<StrandReader>().add<NoParameters>(
      "data",
      {"USC-HairSalon's .data, binary", "",
       "Hu et al., Single-View Hair Modeling Using a Hairstyle Database, SIGGRAPH 2015"},
      [](const NoParameters&) { return std::make_unique<DataReader>(); });
}

}  // namespace ringlet
