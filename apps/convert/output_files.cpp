#include "apps/convert/output_files.h"

#include <spdlog/fmt/fmt.h>

#include <cstdlib>

#include "apps/convert/input_frames.h"
#include "core/suggest.h"
#include "plugins/frame_files.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

const std::vector<OutputFormat>& formats() {
  static const std::vector<OutputFormat> all{
      {"obj", "obj", ""},           {"ply", "ply", ""},
      {"hair", "hair", ""},         {"data", "data", ""},
      {"vtp", "vtp", ""},           {"pvd", "vtp", ""},
      {"usda", "usda", "run.usda"}, {"bin", "frames", "frames.bin"}};
  return all;
}

fs::path numbered(const fs::path& out, int step, const std::string& extension) {
  return out.parent_path() / fmt::format("{}_{:05}.{}", out.stem().string(), step, extension);
}

}  // namespace

OutputFormat output_format(const fs::path& out) {
  const std::string extension = extension_of(out);
  std::vector<std::string> known;
  for (const OutputFormat& format : formats()) {
    if (format.extension == extension) return format;
    known.push_back(format.extension);
  }
  throw Error("'" + out.string() + "': files named '." + extension + "' cannot be written; " +
              did_you_mean(extension, known));
}

std::vector<OutputFile> output_files(const OutputFormat& format, const fs::path& out,
                                     const std::vector<int>& steps) {
  if (!format.file.empty()) return {{format.file, out}};
  const bool has_index = format.extension == "pvd";
  const std::string extension = has_index ? "vtp" : out.extension().string().substr(1);
  std::vector<OutputFile> files;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    // Writers begin with step 0, whatever the step of the first frame is.
    const fs::path made = frame_name(i == 0 ? 0 : steps[i], format.writer);
    const bool is_alone = steps.size() == 1 && !has_index;
    files.push_back({made, is_alone ? out : numbered(out, steps[i], extension)});
  }
  if (has_index) files.push_back({"run.pvd", out});
  return files;
}

void refuse_to_overwrite(const std::vector<OutputFile>& files) {
  for (const OutputFile& file : files) {
    if (!fs::exists(file.wanted)) continue;
    throw Error("'" + file.wanted.string() + "' exists; --force overwrites it");
  }
}

FolderBeside::FolderBeside(const fs::path& file) {
  std::string name = (file.parent_path() / ("." + file.filename().string() + ".XXXXXX")).string();
  if (mkdtemp(name.data()) == nullptr) {
    throw Error("cannot write '" + file.string() +
                "': is its folder there, and may it be written?");
  }
  path_ = name;
}

FolderBeside::~FolderBeside() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

}  // namespace ringlet
