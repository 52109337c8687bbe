#include "plugins/vtp/pvd.h"

#include <spdlog/fmt/fmt.h>

#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/error.h"

namespace ringlet {
namespace {

// The ampersand is the last, so that what it becomes when a file is read is not taken for the
// beginning of another.
constexpr std::array<std::pair<char, const char*>, 4> escapes{
    {{'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'&', "&amp;"}}};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    std::string written(1, letter);
    for (const auto& [plain, escape] : escapes) {
      if (letter == plain) written = escape;
    }
    result += written;
  }
  return result;
}

std::string unescaped(std::string text) {
  for (const auto& [plain, escape] : escapes) {
    const std::string_view written(escape);
    for (std::size_t at = 0; (at = text.find(written, at)) != std::string::npos; ++at) {
      text.replace(at, written.size(), 1, plain);
    }
  }
  return text;
}

/// The value of an attribute of a tag.
std::string attribute(const std::string& tag, const std::string& name,
                      const std::filesystem::path& path) {
  const std::string begin = " " + name + "=\"";
  const std::size_t at = tag.find(begin);
  const std::size_t end = at == std::string::npos ? at : tag.find('"', at + begin.size());
  if (end == std::string::npos) {
    throw Error("'" + path.string() + "': expected the attribute " + name + " in '<" +
                tag.substr(0, 100) + "'");
  }
  return unescaped(tag.substr(at + begin.size(), end - at - begin.size()));
}

}  // namespace

void write_pvd(const std::vector<PvdEntry>& entries, std::ostream& stream) {
  stream << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n"
            "  <Collection>\n";
  for (const PvdEntry& entry : entries) {
    stream << fmt::format("    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", entry.time,
                          escaped(entry.file));
  }
  stream << "  </Collection>\n</VTKFile>\n";
}

std::vector<PvdEntry> read_pvd(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error("cannot open '" + path.string() + "'");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  if (text.find("type=\"Collection\"") == std::string::npos ||
      text.find("</VTKFile>") == std::string::npos) {
    throw Error("'" + path.string() +
                "' is no whole .pvd: expected a VTKFile of the type Collection");
  }
  std::vector<PvdEntry> entries;
  const std::string begin = "<DataSet";
  for (std::size_t at = 0; (at = text.find(begin, at)) != std::string::npos; ++at) {
    const std::string tag = text.substr(at + 1, text.find('>', at) - at - 1);
    const std::string time = attribute(tag, "timestep", path);
    entries.push_back({0, attribute(tag, "file", path)});
    const auto [end, failure] =
        std::from_chars(time.data(), time.data() + time.size(), entries.back().time);
    if (failure != std::errc() || end != time.data() + time.size()) {
      throw Error("'" + path.string() + "': expected a timestep, found '" + time + "'");
    }
  }
  return entries;
}

std::vector<FrameFile> list_pvd_frames(const std::filesystem::path& path) {
  std::vector<FrameFile> files;
  bool ascend = true;
  for (const PvdEntry& entry : read_pvd(path)) {
    const auto step = step_in_name(entry.file);
    ascend = ascend && step && (files.empty() || *step > files.back().step);
    files.push_back({step.value_or(0), path.parent_path() / entry.file});
  }
  for (std::size_t i = 0; i < files.size() && !ascend; ++i) files[i].step = static_cast<int>(i);
  return files;
}

}  // namespace ringlet
