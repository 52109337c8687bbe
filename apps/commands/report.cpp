// Writes one HTML file of a run: strands in 3D, plots, and what they were computed with.

#include "apps/report/report.h"

#include <spdlog/spdlog.h>

#include "apps/commands/command.h"
#include "apps/exit_codes.h"
#include "apps/pages/page_templates.h"
#include "core/atomic_file.h"
#include "core/load_plugin.h"
#include "core/scene.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

constexpr int default_megabytes = 150;

/// Colliders may follow motions of plugins; a report does without them if it must.
void load_plugins_if_there(const fs::path& folder, Registry& registry) {
  const fs::path path = folder / "scene.resolved.json";
  if (!fs::exists(path)) return;
  try {
    load_plugins_of(load_json(path), folder, registry);
  } catch (const InvalidInput& error) {
    spdlog::warn("{}", error.what());
  }
}

int write_report(Registry& registry, const Arguments& arguments) {
  const fs::path folder = *arguments.operand(0);
  const std::string page = report_page_template();
  load_plugins_if_there(folder, registry);
  const std::int64_t megabytes = arguments.integer("--megabytes", 1).value_or(default_megabytes);
  const Report report = make_report(folder, page, megabytes * 1000000, registry);
  const fs::path path = arguments.value("--output").value_or((folder / "report.html").string());
  AtomicFile file(path);
  file.stream() << report.html;
  file.commit();
  for (const std::string& note : report.notes) spdlog::info("{}", note);
  spdlog::info("{:.1f} MB: open {} in a browser", 1e-6 * static_cast<double>(report.html.size()),
               path.string());
  return exit_ok;
}

}  // namespace

Command report_command() {
  return {"report",
          {"DIR"},
          "writes one HTML file of a run: the strands in 3D, and plots",
          {{.name = "--output",
            .value = "FILE.html",
            .meaning = "DIR/report.html if absent",
            .short_name = "-o"},
           {.name = "--megabytes",
            .value = "N",
            .meaning = "of positions before they are packed, 150 if absent; what is more is "
                       "thinned: frames, then strands"}},
          write_report};
}

}  // namespace ringlet
