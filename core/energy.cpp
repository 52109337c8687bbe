#include "core/energy.h"

namespace ringlet {

double add_at_vertices(const Energy& energy, int group, std::span<const Vector3<Pack>> x,
                       const GroupOutputs& outputs) {
  EdgeDerivatives edges;
  edges.begin(static_cast<int>(x.size()));
  EdgeOutputs wanted = edges.outputs();
  if (outputs.gradient.empty()) wanted.gradient = {};
  if (outputs.hessian.empty()) wanted.hessian = {};
  const double value = energy.add(group, x, wanted);
  edges.add_to(outputs);
  return value;
}

}  // namespace ringlet
