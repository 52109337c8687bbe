#include "core/checkpoint.h"

#include <cstdint>

#include "core/binary.h"
#include "core/changing_data.h"
#include "core/plugin.h"

namespace ringlet {
namespace {

/// Other builds compute other bits, and hold what terms change in another way.
std::string stamp() {
  return std::string("ringlet ") + this_build.version + ", " + this_build.compiler + ", packs of " +
         std::to_string(this_build.lanes);
}

template <class Values>
void append_all(std::string& bytes, const Values& values) {
  append_bytes(bytes, static_cast<std::uint64_t>(values.size()));
  for (const auto& value : values) append_bytes(bytes, value);
}

template <class T>
std::vector<T> take_all(ByteReader& from) {
  const auto count = from.take<std::uint64_t>();
  if (count > from.left() / sizeof(T)) throw Error("it ends too early");
  std::vector<T> values(count);
  for (T& value : values) value = from.take<T>();
  return values;
}

void append_field(std::string& bytes, const VertexField& field) {
  const Eigen::Matrix3Xd values = field.matrix();
  append_all(bytes, values.reshaped());
}

VertexField take_field(ByteReader& from, VertexField start) {
  const std::vector<double> values = take_all<double>(from);
  const Eigen::Index vertices = start.groups().vertex_count();
  if (static_cast<Eigen::Index>(values.size()) != 3 * vertices) {
    throw Error("it is of " + std::to_string(values.size() / 3) + " vertices; expected " +
                std::to_string(vertices));
  }
  start.set_matrix(Eigen::Map<const Eigen::Matrix3Xd>(values.data(), 3, vertices));
  return start;
}

StepHistory take_history(ByteReader& from, const Model& model) {
  StepHistory history;
  history.dt = from.take<double>();
  const auto fields = from.take<std::uint64_t>();
  for (std::uint64_t i = 0; i < fields; ++i) {
    history.fields.push_back(take_field(from, VertexField(model.groups)));
  }
  history.still_steps = take_all<int>(from);
  return history;
}

}  // namespace

std::string write_checkpoint(Model& model, const State& state, int steps_done) {
  ChangingData changing;
  changing.save(model);
  std::string bytes;
  append_all(bytes, stamp());
  append_bytes(bytes, steps_done);
  append_bytes(bytes, state.time);
  append_field(bytes, state.positions);
  append_field(bytes, state.velocities);
  append_bytes(bytes, state.history.dt);
  append_bytes(bytes, static_cast<std::uint64_t>(state.history.fields.size()));
  for (const VertexField& field : state.history.fields) append_field(bytes, field);
  append_all(bytes, state.history.still_steps);
  append_all(bytes, changing.data());
  return bytes;
}

int read_checkpoint(std::string_view bytes, Model& model, State& state) {
  ByteReader from(bytes);
  const std::vector<char> written_by = take_all<char>(from);
  const std::string writer(written_by.begin(), written_by.end());
  if (writer != stamp()) throw Error("it was written by " + writer + "; this is " + stamp());
  const int steps_done = from.take<int>();
  State read{from.take<double>(), {}, {}};
  read.positions = take_field(from, state.positions);
  read.velocities = take_field(from, state.velocities);
  read.history = take_history(from, model);
  ChangingData changing;
  changing.save(model);
  const std::vector<std::byte> changed = take_all<std::byte>(from);
  if (from.left() > 0) throw Error("it goes on after its end");
  changing.set_data(changed);
  changing.restore(model);
  state = std::move(read);
  return steps_done;
}

}  // namespace ringlet
