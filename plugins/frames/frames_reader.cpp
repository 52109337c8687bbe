#include "plugins/frames/frames_reader.h"

#include <limits>

#include "core/binary.h"
#include "core/registry.h"

namespace ringlet {
namespace {

constexpr std::int64_t words_bytes = sizeof frames_first_words - 1, checksum_bytes = 8;

template <class Number>
Eigen::Matrix3Xd take_positions(ByteReader& from, std::int64_t vertices) {
  Eigen::Matrix3Xd positions(3, vertices);
  for (Eigen::Index i = 0; i < positions.size(); ++i) {
    positions.data()[i] = static_cast<double>(from.take<Number>());
  }
  return positions;
}

}  // namespace

FramesReader::FramesReader(std::filesystem::path path)
    : path_(std::move(path)), file_(path_, std::ios::binary) {
  if (!file_) fail("cannot be read");
  read_header();
}

void FramesReader::fail(const std::string& what) const {
  throw Error("'" + path_.string() + "': " + what);
}

void FramesReader::read_header() {
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path_));
  std::string start(words_bytes + 8, '\0');
  file_.read(start.data(), words_bytes + 8);
  if (!file_ || start.compare(0, words_bytes, frames_first_words) != 0) {
    fail("expected a file that begins with '" + std::string(frames_first_words) + "'");
  }
  const auto length = ByteReader(std::string_view(start).substr(words_bytes)).take<std::uint64_t>();
  const std::int64_t left = size - words_bytes - 8;
  if (length > static_cast<std::uint64_t>(left)) fail("its header is longer than the file");
  std::string text(length, '\0');
  file_.read(text.data(), static_cast<std::streamsize>(length));
  const Json json = Json::parse(text, nullptr, false);
  const Registry registry;
  std::vector<Problem> problems;
  ParseContext context{registry, ".", {}, problems};
  FramesHeader::schema().read(json, "", context, header_);
  if (!problems.empty()) fail("its header: " + problems[0].pointer + ": " + problems[0].message);
  if (header_.vertex_count() > std::numeric_limits<int>::max()) fail("it has too many vertices");
  first_frame_ =
      words_bytes + 8 + static_cast<std::int64_t>(length) + header_.radii_bytes() + checksum_bytes;
  if (first_frame_ > size) fail("it ends before its first frame");
  read_radii(text);
}

void FramesReader::read_radii(const std::string& header) {
  std::string bytes(header_.radii_bytes(), '\0'), end(checksum_bytes, '\0');
  file_.read(bytes.data(), header_.radii_bytes());
  file_.read(end.data(), checksum_bytes);
  if (!file_ || checksum(header + bytes) != ByteReader(end).take<std::uint64_t>()) {
    fail("its head is damaged: the checksum is wrong");
  }
  ByteReader radii(bytes);
  for (std::int64_t v = 0; v < header_.vertex_count(); ++v) {
    radii_.push_back(static_cast<double>(radii.take<float>()));
  }
}

int FramesReader::count() const {
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(path_));
  return static_cast<int>((size - first_frame_) / header_.frame_bytes());
}

std::string FramesReader::read_bytes(int frame, std::int64_t count_of_bytes) {
  if (frame < 0 || frame >= count()) {
    fail("there is no frame " + std::to_string(frame) + " of " + std::to_string(count()));
  }
  std::string bytes(count_of_bytes, '\0');
  file_.clear();
  file_.seekg(first_frame_ + frame * header_.frame_bytes());
  file_.read(bytes.data(), count_of_bytes);
  if (!file_) fail("frame " + std::to_string(frame) + " cannot be read");
  return bytes;
}

std::int64_t FramesReader::step(int frame) {
  return ByteReader(read_bytes(frame, 8)).take<std::int64_t>();
}

StoredFrame FramesReader::read(int frame) {
  std::string bytes = read_bytes(frame, header_.frame_bytes());
  const auto expected = ByteReader(std::string_view(bytes).substr(bytes.size() - checksum_bytes))
                            .take<std::uint64_t>();
  bytes.resize(bytes.size() - checksum_bytes);
  if (checksum(bytes) != expected) {
    fail("frame " + std::to_string(frame) + " is damaged: its checksum is wrong");
  }
  ByteReader from(bytes);
  StoredFrame stored{from.take<std::int64_t>(), 0, {}};
  stored.time = from.take<double>();
  stored.positions = header_.precision == FramePrecision::single
                         ? take_positions<float>(from, header_.vertex_count())
                         : take_positions<double>(from, header_.vertex_count());
  return stored;
}

}  // namespace ringlet
