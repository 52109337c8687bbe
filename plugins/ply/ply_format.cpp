#include "plugins/ply/ply_format.h"

#include <spdlog/fmt/fmt.h>

#include <cstdint>

#include "plugins/little_endian.h"

namespace ringlet {
namespace {

void write_header(const Strands& strands, const State& state, PlyEncoding encoding,
                  std::ostream& stream) {
  stream << fmt::format(
      "ply\nformat {} 1.0\ncomment ringlet: strands in m, +y up, at {} s\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property float radius\nelement edge {}\nproperty int vertex1\nproperty int vertex2\n"
      "end_header\n",
      encoding == PlyEncoding::binary ? "binary_little_endian" : "ascii", state.time,
      strands.vertex_count(), strands.edge_count());
}

/// visit(vertex, vertex) for each edge.
template <class Visit>
void for_each_edge(const Strands& strands, const Visit& visit) {
  for (int strand = 0; strand < strands.count(); ++strand) {
    for (int v = strands.first(strand); v + 1 < strands.first(strand + 1); ++v) visit(v, v + 1);
  }
}

void write_binary(const Strands& strands, const State& state, std::ostream& stream) {
  for (int v = 0; v < strands.vertex_count(); ++v) {
    put_point(stream, state.positions.get(v));
    put(stream, static_cast<float>(strands.radius(v)));
  }
  for_each_edge(strands, [&](int from, int to) {
    put(stream, std::int32_t{from});
    put(stream, std::int32_t{to});
  });
}

void write_ascii(const Strands& strands, const State& state, std::ostream& stream) {
  for (int v = 0; v < strands.vertex_count(); ++v) {
    const Eigen::Vector3f x = state.positions.get(v).cast<float>();
    stream << fmt::format("{} {} {} {}\n", x[0], x[1], x[2], static_cast<float>(strands.radius(v)));
  }
  for_each_edge(strands, [&](int from, int to) { stream << from << ' ' << to << '\n'; });
}

}  // namespace

void write_ply(const Strands& strands, const State& state, PlyEncoding encoding,
               std::ostream& stream) {
  write_header(strands, state, encoding, stream);
  if (encoding == PlyEncoding::binary) {
    write_binary(strands, state, stream);
  } else {
    write_ascii(strands, state, stream);
  }
}

}  // namespace ringlet
