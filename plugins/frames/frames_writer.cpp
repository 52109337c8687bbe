#include "plugins/frames/frames_writer.h"

#include "core/binary.h"
#include "plugins/frames/frames_reader.h"

namespace ringlet {
namespace {

template <class Number>
void append_positions(std::string& bytes, const VertexField& positions) {
  for (int v = 0; v < positions.groups().vertex_count(); ++v) {
    const Eigen::Vector3d p = positions.get(v);
    for (int c = 0; c < 3; ++c) append_bytes(bytes, static_cast<Number>(p[c]));
  }
}

FramesHeader header_of(const Strands& strands, FramePrecision precision) {
  FramesHeader header{{}, precision};
  for (int strand = 0; strand < strands.count(); ++strand) {
    header.vertex_counts.push_back(strands.size(strand));
  }
  return header;
}

}  // namespace

void FramesWriter::begin(const Model& model, const State& state,
                         const std::filesystem::path& folder) {
  open(folder, std::ios::trunc);
  std::string head =
      FramesHeader::schema().write(header_of(model.strands, parameters_.precision)).dump();
  std::string bytes = frames_first_words;
  append_bytes(bytes, static_cast<std::uint64_t>(head.size()));
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    append_bytes(head, static_cast<float>(model.strands.radius(v)));
  }
  append_bytes(head, checksum(head));
  write(bytes + head);
  append(state, 0);
}

void FramesWriter::resume(const Model& model, const State&, const std::filesystem::path& folder,
                          int step) {
  FramesReader written(folder / "frames.bin");
  if (written.header() != header_of(model.strands, parameters_.precision)) {
    throw Error("'" + (folder / "frames.bin").string() + "' is of other strands or precision");
  }
  int kept = 0;
  for (; kept < written.count(); ++kept) {
    const std::int64_t frame_step = written.step(kept);
    if (frame_step > step || frame_step % parameters_.every != 0) break;
    last_step_ = static_cast<int>(frame_step);
  }
  std::filesystem::resize_file(folder / "frames.bin", written.bytes_with(kept));
  open(folder, std::ios::app);
}

void FramesWriter::observe(const Model&, const State& state, int step, const StepReport&) {
  if (step % parameters_.every == 0) append(state, step);
}

void FramesWriter::end(const Model&, const State& state, int step) {
  if (last_step_ != step) append(state, step);
}

void FramesWriter::open(const std::filesystem::path& folder, std::ios::openmode how) {
  path_ = folder / "frames.bin";
  file_.open(path_, std::ios::binary | how);
}

void FramesWriter::append(const State& state, int step) {
  std::string bytes;
  append_bytes(bytes, static_cast<std::int64_t>(step));
  append_bytes(bytes, state.time);
  if (parameters_.precision == FramePrecision::single) {
    append_positions<float>(bytes, state.positions);
  } else {
    append_positions<double>(bytes, state.positions);
  }
  append_bytes(bytes, checksum(bytes));
  write(bytes);
  last_step_ = step;
}

void FramesWriter::write(const std::string& bytes) {
  file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file_.flush();
  if (!file_) throw Error("cannot write '" + path_.string() + "'; is the disk full?");
}

}  // namespace ringlet
