#include "apps/study/study.h"

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <thread>

#include "apps/interrupt.h"
#include "apps/machine.h"
#include "apps/study/run_results.h"
#include "apps/study/study_progress.h"
#include "apps/study/study_results.h"
#include "apps/study/variant_run.h"
#include "core/atomic_file.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& path, const std::string& text) {
  AtomicFile file(path);
  file.stream() << text;
  file.commit();
}

std::string scene_name(const StudyFile& study) {
  if (study.scene.is_string()) return fs::path(study.scene.get<std::string>()).stem().string();
  return study.scene.is_null() ? "several scenes" : "a scene of its own";
}

Json describe_axes(const StudyFile& study) {
  Json axes = Json::array();
  for (const StudyAxis& axis : study.axes) {
    Json values = Json::array();
    for (const Json& value : axis.values) values.push_back(in_words(value));
    axes.push_back(
        {{"name", axis.name}, {"label", axis.label}, {"unit", axis.unit}, {"values", values}});
  }
  return axes;
}

Json describe_errors(const StudyFile& study) {
  Json errors = Json::array();
  for (const std::string& name : study.errors) {
    for (const ErrorMeasure& measure : error_measures()) {
      if (measure.name != name) continue;
      errors.push_back({{"name", name}, {"label", measure.label}, {"unit", measure.unit}});
    }
  }
  return errors;
}

class StudyRun {
 public:
  StudyRun(const std::string& name, const StudyFile& study, const StudyVariants& variants,
           const StudyOptions& options)
      : variants_(variants),
        options_(options),
        entries_(variants.variants.size()),
        progress_(static_cast<int>(variants.variants.size()) + (variants.reference ? 1 : 0),
                  options.quiet) {
    results_ = {{"study", {{"name", name}, {"about", study.about}, {"scene", scene_name(study)}}},
                {"duration", study.duration ? Json(*study.duration) : Json()},
                {"compare_every", study.compare_every ? Json(*study.compare_every) : Json()},
                {"repetitions", study.repetitions},
                {"machine", describe_machine()},
                {"jobs", options.jobs},
                {"timing_note", timing_note()},
                {"errors", study.reference ? describe_errors(study) : Json::array()},
                {"axes", describe_axes(study)},
                {"default", variants.as_it_stands}};
    results_["machine"]["threads"] = options.threads;
    settings_ = {options.folder, study.repetitions, options.threads,
                 [this] { return interrupt_.requested() || has_failed_; }};
  }

  StudyOutcome run() {
    run_reference();
    std::vector<std::thread> workers;
    for (int i = 0; i < options_.jobs; ++i) workers.emplace_back([this] { work(); });
    for (std::thread& worker : workers) worker.join();
    if (failure_) std::rethrow_exception(failure_);
    write();
    return {results_, interrupt_.requested()};
  }

 private:
  std::string timing_note() const {
    if (options_.jobs == 1) return "";
    return fmt::format(
        "{} variants ran at once and shared the machine: their times are longer than alone, and "
        "not equally so. Errors are exact.",
        options_.jobs);
  }

  std::string run_path(const Variant& variant) const {
    return fs::relative(variant_folder(options_.folder, variant) / "1", options_.folder).string();
  }

  void run_reference() {
    if (!variants_.reference) return;
    const Variant& variant = *variants_.reference;
    if (!variant.refusal.empty()) throw Error("the reference is refused: " + variant.refusal);
    progress_.start(variant.name);
    RunSettings settings = settings_;
    settings.repetitions = 1;
    reference_ = read_results(variant, run_variant(variant, settings));
    progress_.end(variant.name);
    results_["reference"] = describe_variant(variant, *reference_, nullptr, run_path(variant));
    if (reference_->status == "failed") throw Error("the reference failed: " + reference_->reason);
    if (reference_->status == "interrupted") reference_.reset();
  }

  /// Takes variants until none is left.
  void work() {
    try {
      for (std::size_t i; (i = next_++) < entries_.size();) run_one(i);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
      has_failed_ = true;
    }
  }

  void run_one(std::size_t index) {
    const Variant& variant = variants_.variants[index];
    std::vector<fs::path> runs;
    if (variant.refusal.empty() && !settings_.stop()) {
      progress_.start(variant.name);
      runs = run_variant(variant, settings_);
    }
    Json entry = describe_variant(variant, read_results(variant, runs),
                                  reference_ ? &*reference_ : nullptr, run_path(variant));
    const std::lock_guard lock(mutex_);
    entries_[index] = std::move(entry);
    progress_.end(variant.name);
    write();
  }

  void write() {
    results_["variants"] = Json::array();
    for (const Json& entry : entries_) {
      if (!entry.is_null()) results_["variants"].push_back(entry);
    }
    add_fronts(results_);
    write_text(options_.folder / "results.json", results_.dump(2) + "\n");
    write_text(options_.folder / "results.csv", to_csv(results_));
  }

  const StudyVariants& variants_;
  const StudyOptions& options_;
  const Interrupt interrupt_;
  RunSettings settings_;
  Json results_;
  std::vector<Json> entries_;  // of each variant; null: not yet
  std::optional<RunResults> reference_;
  StudyProgress progress_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> has_failed_ = false;
  std::mutex mutex_;
  std::exception_ptr failure_;
};

std::string short_number(const Json& value) {
  return value.is_null() ? "-" : fmt::format("{:.3g}", value.get<double>());
}

}  // namespace

StudyOutcome run_study(const std::string& name, const StudyFile& study,
                       const StudyVariants& variants, const StudyOptions& options) {
  const bool all_refused =
      std::none_of(variants.variants.begin(), variants.variants.end(),
                   [](const Variant& variant) { return variant.refusal.empty(); });
  if (all_refused) {
    throw Error("all variants are refused, the first one since:\n" +
                variants.variants.front().refusal);
  }
  fs::create_directories(options.folder);
  return StudyRun(name, study, variants, options).run();
}

namespace {

/// "74 held, 2 refused with reason".
std::string count_verdicts(const Json& variants) {
  std::map<std::string, int> counts;
  for (const Json& variant : variants) ++counts[variant["verdict"]];
  std::vector<std::string> words;
  for (const auto& [verdict, count] : counts) words.push_back(fmt::format("{} {}", count, verdict));
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::string tell_results(const Json& results) {
  std::size_t width = 7;
  for (const Json& variant : results["variants"]) {
    width = std::max(width, variant["name"].get<std::string>().size());
  }
  const bool has_errors = !results["errors"].empty();
  const std::string error = has_errors ? results["errors"][0]["name"].get<std::string>() : "";
  std::string text =
      fmt::format("{:<{}}  {:<13}  {:>9}  {}\n", "variant", width, "status", "seconds", error);
  for (const Json& variant : results["variants"]) {
    const auto name = variant["name"].get<std::string>();
    const bool is_in_front =
        has_errors && results["fronts"].contains(error) &&
        std::find(results["fronts"][error].begin(), results["fronts"][error].end(), name) !=
            results["fronts"][error].end();
    text += fmt::format("{:<{}}  {:<13}  {:>9}  {}{}{}\n", name, width,
                        variant["status"].get<std::string>(), short_number(variant["seconds"]),
                        has_errors ? short_number(variant["errors"][error]) : "",
                        is_in_front ? "  front" : "",
                        variant["reason"].get<std::string>().empty()
                            ? ""
                            : "  (" + variant["reason"].get<std::string>() + ")");
  }
  if (has_errors && results["recommendations"].contains(error)) {
    for (const Json& words : results["recommendations"][error]) {
      text += words.get<std::string>() + "\n";
    }
  }
  text += count_verdicts(results["variants"]) + "\n";
  return text;
}

}  // namespace ringlet
