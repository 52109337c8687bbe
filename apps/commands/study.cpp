// Runs the variants of a study and weighs their errors against their times.

#include "apps/study/study.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <thread>

#include "apps/commands/command.h"
#include "apps/exit_codes.h"
#include "apps/study/page.h"
#include "apps/study/picture.h"
#include "core/atomic_file.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

/// A study goes on in its own folder, but no other is touched.
fs::path study_folder(const std::optional<std::string>& wanted, const std::string& name) {
  const fs::path folder = wanted ? fs::path(*wanted) : fs::path("results") / name;
  const bool is_new = !fs::exists(folder) || (fs::is_directory(folder) && fs::is_empty(folder));
  if (!is_new && !fs::exists(folder / "results.json") && !fs::exists(folder / "runs")) {
    throw Error("'" + folder.string() +
                "' exists and is not the folder of a study; name another one or remove it");
  }
  return fs::absolute(folder);
}

/// What needs other programs is told where it is missing, and is no reason to fail.
template <class Show>
void show(const Show& show_it) {
  try {
    show_it();
  } catch (const Error& error) {
    spdlog::warn("{}", error.what());
  }
}

void show_results(const Json& results, const fs::path& folder) {
  show([&] {
    AtomicFile file(folder / "study.html");
    file.stream() << study_page(results);
    file.commit();
  });
  show([&] { draw_study(results, folder / "study.png"); });
}

int study(Registry& registry, const Arguments& arguments) {
  const fs::path path = *arguments.operand(0);
  const StudyFile file = read_study_file(path);
  const StudyVariants variants = make_variants(file, path.parent_path(), registry);
  const std::string name = path.stem().string();
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int jobs = static_cast<int>(arguments.integer("--jobs", 1).value_or(1));
  const int threads =
      static_cast<int>(arguments.integer("--threads", 1).value_or(std::max(1, cores / jobs)));
  const fs::path folder = study_folder(arguments.value("--output"), name);
  const StudyOutcome outcome =
      run_study(name, file, variants, {folder, jobs, threads, arguments.has("--quiet")});
  if (outcome.interrupted) {
    spdlog::warn("interrupted; the same command goes on");
    return exit_interrupted;
  }
  show_results(outcome.results, folder);
  fmt::print(stderr, "\n{}\n", tell_results(outcome.results));
  fmt::print("{}\n", folder.string());
  const auto& all = outcome.results["variants"];
  const bool as_expected = std::none_of(all.begin(), all.end(), [](const Json& variant) {
    return variant["status"] == "unexpected";
  });
  return as_expected ? exit_ok : exit_unexpected;
}

}  // namespace

Command study_command() {
  return {"study",
          {"STUDY.json"},
          "runs variants of a scene and weighs their errors against their times",
          {{.name = "--output",
            .value = "DIR",
            .meaning = "folder of the results; results/STUDY if absent; what is there of the same "
                       "study is kept",
            .short_name = "-o"},
           {.name = "--jobs",
            .value = "N",
            .meaning = "variants at once, 1 if absent; more falsify the times, which is told"},
           {.name = "--threads", .value = "N", .meaning = "of each run; all cores if absent"},
           {.name = "--quiet", .meaning = "no progress"}},
          study};
}

}  // namespace ringlet
