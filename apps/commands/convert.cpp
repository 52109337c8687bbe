// Writes strands again in another format: those of a file, or the frames of a run.

#include <spdlog/spdlog.h>

#include <charconv>

#include "apps/commands/command.h"
#include "apps/convert/input_frames.h"
#include "apps/convert/output_files.h"
#include "apps/convert/write_again.h"
#include "apps/exit_codes.h"
#include "apps/run_folder.h"
#include "core/atomic_file.h"
#include "core/load_plugin.h"
#include "core/simulation.h"
#include "plugins/vtp/pvd.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

double positive_number(const Arguments& arguments, const std::string& option, double otherwise) {
  const auto text = arguments.value(option);
  if (!text) return otherwise;
  double value = 0;
  const char* end_of_text = text->data() + text->size();
  const auto [end, failure] = std::from_chars(text->data(), end_of_text, value);
  if (failure != std::errc() || end != end_of_text || !(value > 0) || value > 1e30) {
    throw Error("'" + option + "' expects a number > 0, found '" + *text + "'");
  }
  return value;
}

/// OUT, also where it is written as a folder: OUT/.
fs::path output_path(const Arguments& arguments) {
  const fs::path out = *arguments.operand(1);
  return out.has_filename() ? out : out.parent_path();
}

InputFrames read_input(const Registry& registry, const Arguments& arguments) {
  InputUnits units;
  units.scale = positive_number(arguments, "--scale", units.scale);
  units.radius = positive_number(arguments, "--radius", units.radius);
  const InputFrames frames = open_input(*arguments.operand(0), units, registry);
  const auto step = arguments.integer("--frame", 0);
  return step ? only_frame(frames, *step) : frames;
}

std::string in_words(const InputFrames& frames) {
  const std::size_t strands = frames.vertex_counts.size(), states = frames.steps.size();
  return fmt::format("{} strand{}, {} frame{}", strands, strands == 1 ? "" : "s", states,
                     states == 1 ? "" : "s");
}

/// Of a name, or of JSON {"type": NAME, ...}.
Choice<Observer> read_writer(const std::string& text, const Registry& registry) {
  std::vector<Problem> problems;
  ParseContext context{registry, fs::current_path(), {}, problems};
  Choice<Observer> writer;
  try {
    const Json json = text.starts_with('{') ? Json::parse(text) : Json(text);
    Codec<Choice<Observer>>::read(json, "/write", {}, context, writer);
  } catch (const Json::exception& error) {
    throw Error("'--write' expects the name of a writer or JSON {\"type\": NAME, ...}: " +
                std::string(error.what()));
  }
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return writer;
}

/// The index of frames/frame_<step>.vtp becomes one of the files that they are renamed to.
void rename_frames(const fs::path& index, const std::vector<OutputFile>& files) {
  std::vector<PvdEntry> entries = read_pvd(index);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    entries[i].file = files[i].wanted.filename().string();
  }
  AtomicFile file(index);
  write_pvd(entries, file.stream());
  file.commit();
}

void write_bare(const InputFrames& frames, const std::string& writer, const fs::path& folder,
                const Registry& registry) {
  const auto model = model_of(frames, registry);
  const State state{0, VertexField(model->groups), VertexField(model->groups)};
  write_again(frames, *model, state, *read_writer(writer, registry).make(), folder);
}

/// The writer sees all that it would have seen of the scene when it ran.
void write_in_scene(const InputFrames& frames, const std::string& writer, const fs::path& run,
                    const fs::path& folder, Registry& registry) {
  const Json json = load_json(run / "scene.resolved.json");
  load_plugins_of(json, run, registry);
  const Choice<Observer> choice = read_writer(writer, registry);
  const Simulation simulation(read_scene(json, registry, run));
  require_same_strands(frames, simulation.model().strands);
  write_again(frames, simulation.model(), simulation.state(), *choice.make(), folder);
}

int write_folder(Registry& registry, const Arguments& arguments) {
  const fs::path in = *arguments.operand(0), out = output_path(arguments);
  const std::string writer = *arguments.value("--write");
  if (fs::exists(out)) throw Error("'" + out.string() + "' exists; expected a new folder");
  const InputFrames frames = read_input(registry, arguments);
  const FolderBeside folder(out);
  if (fs::exists(in / "scene.resolved.json")) {
    write_in_scene(frames, writer, in, folder.path(), registry);
  } else {
    write_bare(frames, writer, folder.path(), registry);
  }
  create_empty_folder(out);
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    fs::rename(entry.path(), out / entry.path().filename());
  }
  spdlog::info("{}: {}", in_words(frames), out.string());
  return exit_ok;
}

int write_files(Registry& registry, const Arguments& arguments) {
  const fs::path out = output_path(arguments);
  const OutputFormat format = output_format(out);
  const InputFrames frames = read_input(registry, arguments);
  const std::vector<OutputFile> files = output_files(format, out, frames.steps);
  if (!arguments.has("--force")) refuse_to_overwrite(files);
  const FolderBeside folder(out);
  write_bare(frames, format.writer, folder.path(), registry);
  if (format.extension == "pvd") rename_frames(folder.path() / "run.pvd", files);
  for (const OutputFile& file : files) fs::rename(folder.path() / file.made, file.wanted);
  spdlog::info("{}: {}", in_words(frames),
               files.size() == 1
                   ? out.string()
                   : files.front().wanted.string() + " to " + files.back().wanted.string());
  return exit_ok;
}

int convert(Registry& registry, const Arguments& arguments) {
  try {
    return arguments.has("--write") ? write_folder(registry, arguments)
                                    : write_files(registry, arguments);
  } catch (const fs::filesystem_error& error) {
    throw Error(error.what());
  }
}

}  // namespace

Command convert_command() {
  return {"convert",
          {"IN", "OUT"},
          "writes strands of a file, or the frames of a run folder, in another format",
          {{.name = "--frame",
            .value = "N",
            .meaning = "of IN only the state after step N; all if absent"},
           {.name = "--write",
            .value = "WRITER",
            .meaning = "any writer, by its name or as JSON in a scene, which writes all frames "
                       "again, into the folder OUT"},
           {.name = "--scale", .value = "M", .meaning = "metres of a unit of IN; 1 if absent"},
           {.name = "--radius",
            .value = "M",
            .meaning = "of strands where IN has no radii; 4e-5 if absent"},
           {.name = "--force", .meaning = "overwrites files; never a folder"}},
          convert};
}

}  // namespace ringlet
