#include "solvers/integrators/first_guess.h"

#include <map>
#include <string>

#include "core/simulation.h"

namespace ringlet {
namespace {

void carry_strand(const Strands& strands, int strand, const Eigen::Isometry3d& moved,
                  VertexField& x) {
  for (int v = strands.first(strand); v < strands.first(strand) + strands.size(strand); ++v) {
    x.set(v, moved * x.get(v));
  }
}

}  // namespace

void carry_strands_with_pins(const Model& model, double time, double time_end, VertexField& x) {
  std::map<std::string, Eigen::Isometry3d> moved;
  int last_strand = -1;
  for (const Pin& pin : model.pins) {
    const int strand = model.strands.strand_of(pin.vertex);
    if (strand == last_strand || pin.motion.empty()) continue;
    last_strand = strand;
    auto found = moved.find(pin.motion);
    if (found == moved.end()) {
      const Eigen::Isometry3d begin = model.motions.at(pin.motion, time);
      const Eigen::Isometry3d end = model.motions.at(pin.motion, time_end);
      found = moved.emplace(pin.motion, end * begin.inverse()).first;
    }
    carry_strand(model.strands, strand, found->second, x);
  }
  place_pins(model, time_end, x);
}

}  // namespace ringlet
