// The .hair format of Cem Yuksel. Little endian: a header of 128 bytes, then the arrays whose bit
// is set in it: u16 segments of each strand, f32 points, thickness, transparency, colours.
// Thickness is taken for the diameter; transparency and colours are not read. Source:
// http://www.cemyuksel.com/research/hairmodels
#include <cmath>
#include <limits>

#include "core/readers/file_bytes.h"
#include "core/registry.h"
#include "core/strand_reader.h"

namespace ringlet {
namespace {

struct Header {
  std::uint32_t strands;
  std::uint32_t points;
  bool has_segments;
  bool has_thickness;
  std::uint32_t default_segments;
  float default_thickness;
};

std::string in_words(std::uint64_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun;
}

Header take_header(FileBytes& bytes) {
  bytes.require(128, "header");
  for (const char letter : std::string("HAIR")) {
    if (bytes.take<char>("magic word") != letter) bytes.fail("expected the magic word 'HAIR'");
  }
  Header header{};
  header.strands = bytes.take<std::uint32_t>("number of strands");
  header.points = bytes.take<std::uint32_t>("number of points");
  const auto arrays = bytes.take<std::uint32_t>("bits of the arrays");
  header.has_segments = (arrays & 1u) != 0;
  if ((arrays & 2u) == 0) bytes.fail("expected bit 1 of the arrays set: the file has no points");
  header.default_segments = bytes.take<std::uint32_t>("default number of segments");
  header.has_thickness = (arrays & 4u) != 0;
  header.default_thickness = bytes.take<float>("default thickness");
  bytes.skip(128 - 24, "header");

  const std::uint64_t per_strand = header.has_segments ? 2 : 0;
  const std::uint64_t per_point = 12 + (header.has_thickness ? 4 : 0) +
                                  ((arrays & 8u) != 0 ? 4 : 0) + ((arrays & 16u) != 0 ? 12 : 0);
  bytes.require(
      per_strand * header.strands + per_point * header.points,
      "arrays of " + in_words(header.strands, "strands and ") + in_words(header.points, "points"));
  if (header.points > std::numeric_limits<int>::max() || header.strands > header.points) {
    bytes.fail("expected no more strands than points and fewer than 2^31 points, found " +
               in_words(header.strands, "and ") + in_words(header.points, "of them"));
  }
  return header;
}

std::vector<int> take_vertex_counts(FileBytes& bytes, const Header& header) {
  std::vector<int> counts;
  std::uint64_t points = 0;
  for (std::uint32_t strand = 0; strand < header.strands; ++strand) {
    const std::uint64_t segments =
        header.has_segments ? bytes.take<std::uint16_t>("segments") : header.default_segments;
    points += segments + 1;
    if (points > header.points) break;
    counts.push_back(static_cast<int>(segments + 1));
  }
  if (points != header.points) {
    bytes.fail("expected strands of " + in_words(header.points, "points in all, found ") +
               (points > header.points ? "more" : std::to_string(points)));
  }
  return counts;
}

// None if any of them makes no sense: a simulation does not need them.
std::vector<double> take_radii(FileBytes& bytes, const Header& header) {
  std::vector<double> radii;
  if (!header.has_thickness && header.default_thickness == 0) return radii;
  for (std::uint32_t i = 0; i < header.points; ++i) {
    const float thickness =
        header.has_thickness ? bytes.take<float>("thickness") : header.default_thickness;
    if (!(thickness >= 0) || !std::isfinite(thickness)) return {};
    radii.push_back(0.5 * static_cast<double>(thickness));
  }
  return radii;
}

class HairReader final : public StrandReader {
 public:
  Polylines read(const std::filesystem::path& file) const override {
    FileBytes bytes(file);
    const Header header = take_header(bytes);
    Polylines polylines;
    polylines.vertex_counts = take_vertex_counts(bytes, header);
    polylines.positions.reserve(header.points);
    for (std::uint32_t i = 0; i < header.points; ++i) {
      polylines.positions.push_back(bytes.take_point());
    }
    polylines.radii = take_radii(bytes, header);
    return polylines;
  }
};

}  // namespace

void register_hair_reader(Registry& registry) {
  registry.of<StrandReader>().add<NoParameters>(
      "hair", {"Cem Yuksel's .hair, binary", "", "http://www.cemyuksel.com/research/hairmodels"},
      [](const NoParameters&) { return std::make_unique<HairReader>(); });
}

}  // namespace ringlet
