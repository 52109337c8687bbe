#include "plugins/frames/frames_writer.h"

#include "core/error.h"

namespace ringlet {
namespace {

template <class T>
void append_bytes(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class Number>
void append_positions(std::string& bytes, const VertexField& positions) {
  for (int v = 0; v < positions.groups().vertex_count(); ++v) {
    const Eigen::Vector3d p = positions.get(v);
    for (int c = 0; c < 3; ++c) append_bytes(bytes, static_cast<Number>(p[c]));
  }
}

}  // namespace

void FramesWriter::begin(const Model& model, const State& state,
                         const std::filesystem::path& folder) {
  path_ = folder / "frames.bin";
  file_.open(path_, std::ios::binary | std::ios::trunc);
  FramesHeader header{{}, parameters_.precision};
  for (int strand = 0; strand < model.strands.count(); ++strand) {
    header.vertex_counts.push_back(model.strands.size(strand));
  }
  std::string head = FramesHeader::schema().write(header).dump();
  std::string bytes = frames_first_words;
  append_bytes(bytes, static_cast<std::uint64_t>(head.size()));
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    append_bytes(head, static_cast<float>(model.strands.radius(v)));
  }
  append_bytes(head, checksum(head));
  write(bytes + head);
  append(state, 0);
}

void FramesWriter::observe(const Model&, const State& state, int step, const StepReport&) {
  if (step % parameters_.every == 0) append(state, step);
}

void FramesWriter::end(const Model&, const State& state, int step) {
  if (last_step_ != step) append(state, step);
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
