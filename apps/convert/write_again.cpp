#include "apps/convert/write_again.h"

namespace ringlet {
namespace {

/// The radii of vertices, and else the default.
MaterialField material_of(const std::vector<double>& radii, const Registry& registry) {
  std::vector<Problem> problems;
  ParseContext context{registry, std::filesystem::current_path(), {}, problems};
  MaterialField material;
  Codec<Varying>::read(Json{{"by_vertex", radii}}, "radii", {}, context, material.radius);
  if (!problems.empty()) throw InvalidInput(std::move(problems));
  return material;
}

void go_to(const RunFrame& frame, State& state) {
  const double dt = frame.time - state.time;
  if (dt > 0) {
    state.velocities.set_matrix((frame.positions - state.positions.matrix()) / dt);
  }
  state.time = frame.time;
  state.positions.set_matrix(frame.positions);
}

}  // namespace

std::unique_ptr<Model> model_of(const InputFrames& frames, const Registry& registry) {
  const Eigen::Matrix3Xd x = frames.read(0).positions;
  std::vector<Eigen::Vector3d> positions;
  for (Eigen::Index v = 0; v < x.cols(); ++v) positions.emplace_back(x.col(v));
  return std::make_unique<Model>(
      Strands(frames.vertex_counts, positions, material_of(frames.radii, registry)));
}

void require_same_strands(const InputFrames& frames, const Strands& strands) {
  std::vector<int> counts;
  for (int strand = 0; strand < strands.count(); ++strand) counts.push_back(strands.size(strand));
  if (counts == frames.vertex_counts) return;
  throw Error("the strands of the frames are not those of scene.resolved.json beside them");
}

void write_again(const InputFrames& frames, const Model& model, State state, Observer& writer,
                 const std::filesystem::path& folder) {
  int last_step = 0;
  for (std::size_t i = 0; i < frames.steps.size(); ++i) {
    const RunFrame frame = frames.read(static_cast<int>(i));
    if (i == 0) {
      state.time = frame.time;
      state.positions.set_matrix(frame.positions);
      naming(writer, [&] { writer.begin(model, state, folder); });
    } else {
      go_to(frame, state);
      last_step = frame.step;
      naming(writer, [&] { writer.observe(model, state, last_step, {}); });
    }
  }
  naming(writer, [&] { writer.end(model, state, last_step); });
}

}  // namespace ringlet
