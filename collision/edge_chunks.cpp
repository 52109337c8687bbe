#include "collision/edge_chunks.h"

namespace ringlet {

std::vector<EdgeChunk> make_edge_chunks(const Strands& strands, int most_edges) {
  std::vector<EdgeChunk> chunks;
  for (int strand = 0; strand < strands.count(); ++strand) {
    const int first = strands.first(strand), edges = strands.size(strand) - 1;
    const int count = (edges + most_edges - 1) / most_edges;
    for (int c = 0; c < count; ++c) {
      const int begin = edges * c / count, end = edges * (c + 1) / count;
      chunks.push_back({first + begin, end - begin, end - begin + (c + 1 == count ? 1 : 0)});
    }
  }
  return chunks;
}

BoundingBox bounding_box(const EdgeChunk& chunk, std::span<const Eigen::Vector3d> positions) {
  BoundingBox box;
  for (const auto& p : positions.subspan(chunk.first, chunk.edges + 1)) box.extend(p);
  return box;
}

}  // namespace ringlet
