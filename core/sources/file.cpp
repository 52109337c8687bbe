// Strands of a file made elsewhere.
#include <spdlog/spdlog.h>

#include <algorithm>
#include <limits>

#include "core/registry.h"
#include "core/sources/merge_short_edges.h"
#include "core/strand_reader.h"
#include "core/strand_source.h"

namespace ringlet {
namespace {

// Against its mass, the stiffness of an edge grows as 1/l^2 and that of a hinge as 1/l^4. One edge
// much shorter than the others would set the conditioning of the whole scene and show nothing. The
// default is relative, so that it holds for fibres and wisps, in metres and in other units.
constexpr double default_minimum_edge = 0.1;

struct StrandFile {
  ScenePath path;
  std::optional<Choice<StrandReader>> format;
  double scale = 1;
  std::optional<double> minimum_edge;
  int pinned = 2;
  MotionName motion;

  static Schema<StrandFile> schema();
};

void choose_format(StrandFile& file, const std::string& pointer, ParseContext& context) {
  if (file.format) return;
  std::string extension = file.path.absolute.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  const auto& readers = context.registry.of<StrandReader>();
  if (readers.find(extension) == nullptr) {
    context.problem(pointer_to(pointer, "path"), "there is no strand reader for files named '." +
                                                     extension + "'; " +
                                                     did_you_mean(extension, readers.names()));
    return;
  }
  file.format = Choice<StrandReader>(extension.c_str());
  Codec<std::optional<Choice<StrandReader>>>::complete(pointer_to(pointer, "format"), context,
                                                       file.format);
}

Schema<StrandFile> StrandFile::schema() {
  return Schema<StrandFile>()
      .required("path", &StrandFile::path, "", any_number(), "the file")
      .key("format", &StrandFile::format, "", any_number(),
           "what reads the file; by the extension of its name if absent")
      .key("scale", &StrandFile::scale, "m", positive(), "length of the file's unit")
      .key("minimum_edge", &StrandFile::minimum_edge, "m", at_least(0),
           "vertices no further from the one before them are merged into it; a tenth of the file's "
           "median edge if absent")
      .key("pinned", &StrandFile::pinned, "", at_least(0),
           "vertices of each strand, from the root, that are held")
      .key("motion", &StrandFile::motion, "", any_number(),
           "name of the motion that the pinned vertices follow; empty: they rest")
      .check(choose_format);
}

class FileSource final : public StrandSource {
 public:
  explicit FileSource(const StrandFile& file) : file_(file) {}

  StrandSet generate() const override {
    const auto reader = file_.format->make();
    Polylines polylines = naming(*reader, [&] { return reader->read(file_.path.absolute); });
    const std::string name = file_.path.absolute.string();
    if (polylines.positions.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
      throw Error("'" + name + "' has more than 2^31 - 1 vertices");
    }
    for (Eigen::Vector3d& x : polylines.positions) x *= file_.scale;
    const auto strands = polylines.vertex_counts.size();
    const MergeReport report = merge_short_edges(
        polylines, file_.minimum_edge.value_or(default_minimum_edge * median_edge(polylines)));
    if (report.merged_vertices > 0 || report.dropped_strands > 0) {
      spdlog::warn(
          "'{}': {} vertices no further than {:.3g} m from their neighbour merged, {} of {} "
          "strands "
          "dropped that have fewer than two vertices so far apart",
          name, report.merged_vertices, report.minimum_edge, report.dropped_strands, strands);
    }
    if (polylines.vertex_counts.empty()) {
      throw Error("'" + name + "' has no strand of two vertices further apart than minimum_edge");
    }
    return hold(std::move(polylines));
  }

 private:
  StrandSet hold(Polylines polylines) const {
    StrandSet set;
    set.vertex_counts = std::move(polylines.vertex_counts);
    set.positions = std::move(polylines.positions);
    for (const int vertices : set.vertex_counts) {
      set.pinned_counts.push_back(std::min(file_.pinned, vertices));
    }
    set.motions.assign(set.vertex_counts.size(), file_.motion.name);
    return set;
  }

  StrandFile file_;
};

}  // namespace

void register_file(Registry& registry) {
  registry.of<StrandSource>().add<StrandFile>(
      "file", {"strands of a file that a strand reader reads: .hair, .obj, .ply, ...", "", ""},
      [](const StrandFile& file) { return std::make_unique<FileSource>(file); });
}

}  // namespace ringlet
