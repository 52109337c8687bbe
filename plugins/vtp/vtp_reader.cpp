#include "plugins/vtp/vtp_reader.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "core/error.h"

namespace ringlet {
namespace {

/// What is wrong with a file, which read_vtp_frame() then names.
class NotWhole : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void require(bool condition, const std::string& what) {
  if (!condition) throw NotWhole(what);
}

class Document {
 public:
  explicit Document(std::string bytes)
      : bytes_(std::move(bytes)), end_of_head_(bytes_.find("<AppendedData")) {
    const bool whole =
        bytes_.find("</VTKFile>", bytes_.size() - std::min<std::size_t>(bytes_.size(), 16)) !=
        std::string::npos;
    require(whole, "it ends before </VTKFile>");
    const char* native =
        std::endian::native == std::endian::little ? "\"LittleEndian\"" : "\"BigEndian\"";
    require(bytes_.find(native) < end_of_head_, "another byte order");
  }

  template <class T>
  std::vector<T> array(const std::string& name) const {
    const std::size_t begin = bytes_.find("Name=\"" + name + "\"");
    require(begin < end_of_head_, "no array " + name);
    const std::size_t close = bytes_.find('>', begin);
    const std::string tag = bytes_.substr(begin, close - begin);
    const std::size_t offset = tag.find("offset=\"");
    return offset == std::string::npos ? written_out<T>(close + 1)
                                       : appended<T>(std::strtoull(&tag[offset + 8], nullptr, 10));
  }

 private:
  template <class T>
  std::vector<T> written_out(std::size_t begin) const {
    std::istringstream text(bytes_.substr(begin, bytes_.find('<', begin) - begin));
    return {std::istream_iterator<T>(text), {}};
  }

  template <class T>
  std::vector<T> appended(std::uint64_t offset) const {
    const std::size_t at = bytes_.find('_', end_of_head_);
    require(at != std::string::npos && offset < bytes_.size(), "no data");
    const std::size_t begin = at + 1 + offset;
    std::uint64_t size = 0;
    require(begin + sizeof(size) <= bytes_.size(), "an offset beyond the end");
    std::memcpy(&size, &bytes_[begin], sizeof(size));
    require(size <= bytes_.size() - begin - sizeof(size), "an array beyond the end");
    std::vector<T> values(size / sizeof(T));
    if (values.empty()) return values;
    std::memcpy(values.data(), &bytes_[begin + sizeof(size)], values.size() * sizeof(T));
    return values;
  }

  std::string bytes_;
  std::size_t end_of_head_;
};

void check(const VtpFrame& frame) {
  require(!frame.offsets.empty() && frame.points.size() == 3 * frame.radii.size() &&
              static_cast<std::size_t>(frame.offsets.back()) == frame.radii.size() &&
              frame.offsets.front() > 0 &&
              std::is_sorted(frame.offsets.begin(), frame.offsets.end()),
          "arrays that do not fit together");
  require(std::all_of(frame.points.begin(), frame.points.end(),
                      [](float coordinate) { return std::isfinite(coordinate); }),
          "a coordinate that is not finite");
}

}  // namespace

VtpFrame read_vtp_frame(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error("cannot open '" + path.string() + "'");
  try {
    const Document document(std::string(std::istreambuf_iterator<char>(file), {}));
    const std::vector<double> time = document.array<double>("TimeValue");
    require(time.size() == 1, "no time");
    VtpFrame frame{time[0], document.array<float>("Points"), document.array<float>("radius"),
                   document.array<std::int32_t>("offsets")};
    check(frame);
    return frame;
  } catch (const NotWhole& problem) {
    throw Error("'" + path.string() + "' is no whole frame of ringlet: " + problem.what());
  }
}

}  // namespace ringlet
