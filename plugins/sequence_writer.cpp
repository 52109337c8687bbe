#include "plugins/sequence_writer.h"

#include <spdlog/fmt/fmt.h>

#include "core/atomic_file.h"

namespace ringlet {

void SequenceWriter::begin(const Model& model, const State& state,
                           const std::filesystem::path& folder) {
  folder_ = folder / "frames";
  std::filesystem::create_directories(folder_);
  write(model, state, 0);
}

void SequenceWriter::observe(const Model& model, const State& state, int step, const StepReport&) {
  if (step % parameters_.every == 0) write(model, state, step);
}

void SequenceWriter::end(const Model& model, const State& state, int step) {
  if (last_step_ != step) write(model, state, step);
}

void SequenceWriter::write(const Model& model, const State& state, int step) {
  AtomicFile file(folder_ / fmt::format("frame_{:05}.{}", step, extension_));
  format_(model.strands, state, file.stream());
  file.commit();
  last_step_ = step;
}

}  // namespace ringlet
