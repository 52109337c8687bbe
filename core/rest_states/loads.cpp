#include "core/rest_states/loads.h"

#include <algorithm>

#include "core/error.h"
#include "core/registry.h"
#include "core/suggest.h"

namespace ringlet {
namespace {

void add_energies(Model& model, bool that_hold, int g, const VertexField& x,
                  VertexField& gradient) {
  for (const auto& energy : model.energies) {
    if ((energy->holding_elements() != nullptr) != that_hold) continue;
    add_at_vertices(*energy, g, x.group(g), {gradient.group(g), {}});
  }
}

void check_forces(const Model& model, const std::vector<std::string>& forces) {
  std::vector<std::string> known;
  for (const auto& force : model.forces) known.push_back(force->name());
  for (const LeftOut& term : model.left_out) {
    if (term.kind == Kind<Force>::name) known.push_back(term.name);
  }
  for (const std::string& name : forces) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw Error("the scene has no force '" + name + "'; " + did_you_mean(name, known));
  }
}

}  // namespace

VertexField gradient_of_loads(Model& model, const VertexField& x,
                              const std::vector<std::string>& forces) {
  check_forces(model, forces);
  VertexField gradient(model.groups);
  // Without a velocity nothing depends on the length of the step.
  const State state{0, x, VertexField(model.groups)};
  const StepStart start{state, 1, model.energies, {x, 1}};
  for (const auto& force : model.forces) {
    if (std::find(forces.begin(), forces.end(), force->name()) == forces.end()) continue;
    naming(*force, [&] {
      force->begin_step(start);
      for (int g = 0; g < model.groups.count(); ++g) {
        force->add(g, x.group(g), {gradient.group(g), {}});
      }
    });
  }
  for (int g = 0; g < model.groups.count(); ++g) add_energies(model, false, g, x, gradient);
  return gradient;
}

void add_gradient_of_holding_energies(Model& model, int group, const VertexField& x,
                                      VertexField& gradient) {
  add_energies(model, true, group, x, gradient);
}

std::vector<double> largest_accelerations(const Model& model, const VertexField& gradient) {
  std::vector<double> largest(model.strands.count());
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    const auto [row, lane] = model.groups.slot(v);
    if (model.free[row][lane] == 0) continue;
    double& of_strand = largest[model.strands.strand_of(v)];
    of_strand = std::max(of_strand, gradient.get(v).norm() / model.strands.mass(v));
  }
  return largest;
}

}  // namespace ringlet
