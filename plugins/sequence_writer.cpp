#include "plugins/sequence_writer.h"

#include "core/atomic_file.h"
#include "plugins/frame_files.h"

namespace ringlet {

void SequenceWriter::begin(const Model& model, const State& state,
                           const std::filesystem::path& folder) {
  keep_files(folder, -1);
  std::filesystem::create_directories(folder_ / "frames");
  write(model, state, 0);
}

void SequenceWriter::resume(const Model&, const State&, const std::filesystem::path& folder,
                            int step) {
  keep_files(folder, step);
}

void SequenceWriter::keep_files(const std::filesystem::path& folder, int last_step) {
  folder_ = folder;
  const auto kept = keep_frame_files(folder_, extension_, parameters_.every, last_step);
  last_step_ = kept.empty() ? -1 : kept.back().step;
}

void SequenceWriter::observe(const Model& model, const State& state, int step, const StepReport&) {
  if (step % parameters_.every == 0) write(model, state, step);
}

void SequenceWriter::end(const Model& model, const State& state, int step) {
  if (last_step_ != step) write(model, state, step);
}

void SequenceWriter::write(const Model& model, const State& state, int step) {
  AtomicFile file(folder_ / frame_name(step, extension_));
  format_(model.strands, state, file.stream());
  file.commit();
  last_step_ = step;
}

}  // namespace ringlet
