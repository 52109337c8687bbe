#include "apps/report/report.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>

#include "apps/pages/fill_page.h"
#include "apps/report/colliders.h"
#include "apps/report/contact_forces.h"
#include "apps/report/metrics_table.h"
#include "apps/report/packed_text.h"
#include "apps/report/quantised.h"
#include "apps/report/run_source.h"
#include "apps/report/shown_frames.h"
#include "core/scene.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

/// Frames that are packed together; the page shows the first before it has unpacked the next.
constexpr std::size_t frames_a_packet = 16;
/// More points than that no plot has pixels for.
constexpr int most_rows = 4000;

Json describe_metrics(const MetricsTable& table, std::vector<std::string>& notes) {
  const int rows = static_cast<int>(table.rows());
  const int every = (rows + most_rows - 1) / most_rows;
  if (every > 1) notes.push_back(fmt::format("The plots show one of {} steps.", every));
  Json columns = Json::array();
  for (const std::vector<double>& column : table.columns) {
    std::vector<double> shown;
    for (const int row : rows == 0 ? std::vector<int>{} : kept(rows, every, true)) {
      shown.push_back(column[row]);
    }
    columns.push_back(std::move(shown));
  }
  return {{"names", table.names}, {"columns", std::move(columns)}};
}

void note_thinning(const ShownFrames& frames, std::vector<std::string>& notes) {
  if (frames.thinning.every_frame > 1) {
    notes.push_back(fmt::format(
        "Shown are {} of {} frames, one of {} and the last; between them motion is interpolated.",
        frames.times.size(), frames.count, frames.thinning.every_frame));
  }
  if (frames.thinning.every_strand > 1) {
    notes.push_back(fmt::format("Shown are {} of {} strands, one of {}.", frames.first.size() - 1,
                                frames.strands, frames.thinning.every_strand));
  }
}

void note_rounding(const Quantisation& box, std::vector<std::string>& notes) {
  const double step = std::max({box.step[0], box.step[1], box.step[2]});
  notes.push_back(fmt::format(
      "Positions are rounded to 16 bits a coordinate: by {:.2g} mm at most.", 0.5e3 * step));
}

/// Of the ball around the centre of the box that holds all positions, m.
double radius_around(const std::array<double, 3>& centre,
                     const std::vector<std::vector<float>>& frames) {
  double squared_radius = 0;
  for (const auto& frame : frames) {
    for (std::size_t i = 0; i < frame.size(); i += 3) {
      const double x = frame[i] - centre[0], y = frame[i + 1] - centre[1],
                   z = frame[i + 2] - centre[2];
      squared_radius = std::max(squared_radius, x * x + y * y + z * z);
    }
  }
  return std::sqrt(squared_radius);
}

/// The texts of some frames at a time: positions, and contact forces if there are any.
std::string pack_all(const ShownFrames& frames, const Quantisation& box, double largest_contact) {
  std::string text;
  for (std::size_t begin = 0; begin < frames.positions.size(); begin += frames_a_packet) {
    const std::size_t end = std::min(begin + frames_a_packet, frames.positions.size());
    std::vector<std::vector<std::uint16_t>> packet;
    for (std::size_t i = begin; i < end; ++i) packet.push_back(box.quantise(frames.positions[i]));
    text +=
        script_element("class=\"frames\" type=\"text/plain\"", pack_frames(packet, frames.first));
    if (frames.contacts.empty()) continue;
    text +=
        script_element("class=\"contacts\" type=\"text/plain\"",
                       pack_contacts({frames.contacts.begin() + static_cast<std::ptrdiff_t>(begin),
                                      frames.contacts.begin() + static_cast<std::ptrdiff_t>(end)},
                                     largest_contact));
  }
  return text;
}

/// N; 0 where there are none.
double find_largest(const std::vector<std::vector<float>>& contacts) {
  double largest = 0;
  for (const auto& frame : contacts) {
    for (const float force : frame) largest = std::max(largest, double{force});
  }
  return largest;
}

std::unique_ptr<ContactForces> make_contact_forces(const Json& scene, const Registry& registry,
                                                   const fs::path& folder,
                                                   std::vector<std::string>& notes) {
  try {
    return ContactForces::of_scene(scene, registry, folder);
  } catch (const std::exception& error) {
    notes.push_back(fmt::format("There is no colour for contacts: {}.", error.what()));
    return nullptr;
  }
}

}  // namespace

Report make_report(const fs::path& folder, const std::string& page, std::int64_t budget_bytes,
                   const Registry& registry) {
  Report report;
  const Json scene = load_scene_of_run(folder), summary = load_summary_of_run(folder);
  const ShownFrames frames =
      read_shown_frames(folder, budget_bytes,
                        make_contact_forces(scene, registry, folder, report.notes), report.notes);
  note_thinning(frames, report.notes);
  const Quantisation box = Quantisation::around(frames.positions);
  note_rounding(box, report.notes);
  const double largest_contact = find_largest(frames.contacts);
  const Json colliders = describe_colliders(scene, registry, frames.times, report.notes);
  const Json metrics = describe_metrics(read_metrics_table(folder / "metrics.csv"), report.notes);
  const Json record{
      {"name", name_of_run(folder)},
      {"scene", scene},
      {"summary", summary},
      {"notes", report.notes},
      {"metrics", metrics},
      {"colliders", colliders},
      {"contacts", frames.contacts.empty() ? Json() : Json{{"largest", largest_contact}}},
      {"strands",
       {{"count", frames.strands},
        {"vertices", frames.vertices},
        {"first", frames.first},
        {"radii", pack_numbers(frames.radii)}}},
      {"frames",
       {{"count", frames.count},
        {"steps", frames.steps},
        {"times", frames.times},
        {"low", box.low},
        {"step", box.step},
        {"centre", box.centre()},
        {"radius", radius_around(box.centre(), frames.positions)}}}};

  report.html =
      fill_page(page, script_element("id=\"record\" type=\"application/json\"",
                                     record.dump(-1, ' ', false, Json::error_handler_t::replace)) +
                          pack_all(frames, box, largest_contact));
  return report;
}

}  // namespace ringlet
