#include "apps/checkpoint_file.h"

#include <fstream>
#include <iterator>

#include "core/atomic_file.h"
#include "core/binary.h"
#include "plugins/frames/frames_format.h"

namespace ringlet {
namespace {

const std::string first_words = "ringlet checkpoint 1\n";

std::filesystem::path path_in(const std::filesystem::path& folder) {
  return folder / "checkpoint.bin";
}

}  // namespace

void write_checkpoint_file(const std::filesystem::path& folder, const std::string& checkpoint) {
  std::string bytes = first_words + checkpoint;
  append_bytes(bytes, checksum(bytes));
  AtomicFile file(path_in(folder));
  file.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.commit();
}

std::optional<std::string> read_checkpoint_file(const std::filesystem::path& folder) {
  const std::filesystem::path path = path_in(folder);
  if (!std::filesystem::exists(path)) return {};
  std::ifstream file(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  constexpr std::size_t end = sizeof(std::uint64_t);
  if (!bytes.starts_with(first_words) || bytes.size() < first_words.size() + end) {
    throw Error("'" + path.string() + "' is no checkpoint of ringlet");
  }
  const auto expected =
      ByteReader(std::string_view(bytes).substr(bytes.size() - end)).take<std::uint64_t>();
  bytes.resize(bytes.size() - end);
  if (checksum(bytes) != expected) {
    throw Error("'" + path.string() + "' is damaged: its checksum is wrong");
  }
  return bytes.substr(first_words.size());
}

}  // namespace ringlet
