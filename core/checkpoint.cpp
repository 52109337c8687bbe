#include "core/checkpoint.h"

#include <algorithm>
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

/// With its pads: they too are where steps have left them.
VertexField take_field(ByteReader& from, const StrandGroups& groups) {
  const auto rows = take_all<Vector3<Pack>>(from);
  VertexField field(groups);
  if (rows.size() != field.rows().size()) throw Error("a field of it has another size");
  std::copy(rows.begin(), rows.end(), field.rows().begin());
  return field;
}

StepHistory take_history(ByteReader& from, const Model& model) {
  StepHistory history;
  history.dt = from.take<double>();
  const auto fields = from.take<std::uint64_t>();
  for (std::uint64_t i = 0; i < fields; ++i) {
    history.fields.push_back(take_field(from, model.groups));
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
  append_bytes(bytes, model.strands.vertex_count());
  append_bytes(bytes, steps_done);
  append_bytes(bytes, state.time);
  append_all(bytes, state.positions.rows());
  append_all(bytes, state.velocities.rows());
  append_bytes(bytes, state.history.dt);
  append_bytes(bytes, static_cast<std::uint64_t>(state.history.fields.size()));
  for (const VertexField& field : state.history.fields) append_all(bytes, field.rows());
  append_all(bytes, state.history.still_steps);
  append_all(bytes, changing.data());
  return bytes;
}

int read_checkpoint(std::string_view bytes, Model& model, State& state) {
  ByteReader from(bytes);
  const std::vector<char> written_by = take_all<char>(from);
  const std::string writer(written_by.begin(), written_by.end());
  if (writer != stamp()) throw Error("it was written by " + writer + "; this is " + stamp());
  if (const int vertices = from.take<int>(); vertices != model.strands.vertex_count()) {
    throw Error("it is of " + std::to_string(vertices) + " vertices; expected " +
                std::to_string(model.strands.vertex_count()));
  }
  const int steps_done = from.take<int>();
  State read{from.take<double>(), {}, {}};
  read.positions = take_field(from, model.groups);
  read.velocities = take_field(from, model.groups);
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
