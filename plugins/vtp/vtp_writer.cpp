#include "plugins/vtp/vtp_writer.h"

#include "core/atomic_file.h"
#include "plugins/vtp/pvd.h"
#include "plugins/vtp/vtp_reader.h"

namespace ringlet {

void VtpWriter::begin(const Model& model, const State& state, const std::filesystem::path& folder) {
  keep_frames(folder, -1);
  std::filesystem::create_directories(folder_ / "frames");
  write_frame(model, state, 0);
}

void VtpWriter::resume(const Model&, const State&, const std::filesystem::path& folder, int step) {
  keep_frames(folder, step);
  write_index();
}

void VtpWriter::keep_frames(const std::filesystem::path& folder, int last) {
  folder_ = folder;
  frames_.clear();
  for (const FrameFile& file : keep_frame_files(folder, "vtp", parameters_.every, last)) {
    frames_.push_back({file.step, read_vtp_frame(file.path).time, frame_name(file.step, "vtp")});
  }
}

void VtpWriter::observe(const Model& model, const State& state, int step, const StepReport&) {
  if (step % parameters_.every == 0) write_frame(model, state, step);
}

void VtpWriter::end(const Model& model, const State& state, int step) {
  if (frames_.empty() || frames_.back().step != step) write_frame(model, state, step);
}

void VtpWriter::write_frame(const Model& model, const State& state, int step) {
  const std::string name = frame_name(step, "vtp");
  AtomicFile file(folder_ / name);
  write_vtp(model.strands, state, parameters_.encoding, file.stream());
  file.commit();
  frames_.push_back({step, state.time, name});
  write_index();
}

void VtpWriter::write_index() const {
  std::vector<PvdEntry> entries;
  for (const Frame& frame : frames_) entries.push_back({frame.time, frame.file});
  AtomicFile file(folder_ / "run.pvd");
  write_pvd(entries, file.stream());
  file.commit();
}

}  // namespace ringlet
