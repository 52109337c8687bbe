#include "core/incremental_potential.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"

namespace ringlet {
namespace {

std::string name_of(const Model& model, int vertex) {
  if (vertex < 0) return "a pad";
  const int strand = model.strands.strand_of(vertex);
  return "strand " + std::to_string(strand) + ", vertex " +
         std::to_string(vertex - model.strands.first(strand));
}

bool is_finite(const Vector3<Pack>& v, int lane) {
  return std::isfinite(v.x[lane]) && std::isfinite(v.y[lane]) && std::isfinite(v.z[lane]);
}

bool is_finite(const GroupBands& bands, int row, int lane) {
  for (int k = 0; k < band_blocks; ++k) {
    for (const Pack& entry : bands.block(row, k).m) {
      if (!std::isfinite(entry[lane])) return false;
    }
  }
  return true;
}

template <class Term>
std::optional<std::string> find_non_finite_term(const Model& model, const VertexField& x,
                                                const Term& term, const std::string& name) {
  for (int g = 0; g < model.groups.count(); ++g) {
    const auto [first_row, vertices, strands] = model.groups[g];
    std::vector<Vector3<Pack>> gradient(vertices, {0, 0, 0});
    std::vector<Matrix3<Pack>> blocks(vertices * band_blocks, Matrix3<Pack>::zero());
    const GroupBands hessian{std::span(blocks)};
    const double value = term.add(g, x.group(g), {gradient, hessian});
    for (int row = 0; row < vertices; ++row) {
      for (int lane = 0; lane < lane_count; ++lane) {
        const std::string where = name_of(model, model.groups.vertex_at(first_row + row, lane));
        const std::string what = "of '" + name + "' at " + where + " is not finite";
        if (!is_finite(gradient[row], lane)) return "the gradient " + what;
        if (!is_finite(hessian, row, lane)) return "the Hessian " + what;
      }
    }
    if (!std::isfinite(value)) return "the value of '" + name + "' is not finite";
  }
  return std::nullopt;
}

/// Makes the gradient zero where nothing is free; returns its squared norm.
double pin_gradient(std::span<Vector3<Pack>> gradient, std::span<const Pack> free) {
  Pack squared = 0;
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    gradient[i] = free[i] * gradient[i];
    squared += squared_norm(gradient[i]);
  }
  return sum_lanes(squared);
}

}  // namespace

double PotentialTerms::total() const {
  return inertia + forces + contacts + std::accumulate(energies.begin(), energies.end(), 0.0);
}

double PotentialTerms::magnitude() const {
  double sum = std::abs(inertia) + std::abs(forces) + std::abs(contacts);
  for (const double energy : energies) sum += std::abs(energy);
  return sum;
}

double IncrementalPotential::add_inertia(int group, const VertexField& x,
                                         GroupOutputs outputs) const {
  const auto rows = x.group(group), target = target_.group(group);
  const Pack* mass = &model_.mass[model_.groups[group].first_row];
  Pack energy = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Pack weight = inverse_h2_ * mass[i];
    const Vector3<Pack> difference = rows[i] - target[i];
    energy += 0.5 * weight * squared_norm(difference);
    if (!outputs.gradient.empty()) outputs.gradient[i] += weight * difference;
    if (!outputs.hessian.empty()) {
      for (int c = 0; c < 3; ++c) outputs.hessian.block(static_cast<int>(i), 0)(c, c) += weight;
    }
  }
  return sum_lanes(energy);
}

void IncrementalPotential::add_group(int group, const VertexField& x, GroupOutputs outputs,
                                     std::span<double> terms) const {
  std::size_t term = 0;
  terms[term++] = add_inertia(group, x, outputs);
  for (const auto& energy : model_.energies) {
    terms[term++] = energy->add(group, x.group(group), outputs);
  }
  for (const auto& force : model_.forces) {
    terms[term] += force->add(group, x.group(group), outputs);
  }
}

PotentialTerms IncrementalPotential::sum(std::span<const double> terms_of_groups) const {
  PotentialTerms total;
  total.energies.assign(model_.energies.size(), 0.0);
  for (int g = 0; g < model_.groups.count(); ++g) {
    const auto terms = terms_of_groups.subspan(g * term_count(), term_count());
    total.inertia += terms.front();
    for (std::size_t e = 0; e < total.energies.size(); ++e) total.energies[e] += terms[e + 1];
    total.forces += terms.back();
  }
  return total;
}

PotentialTerms IncrementalPotential::value(const VertexField& x) const {
  std::vector<double> terms(model_.groups.count() * term_count());
  parallel_for_each(model_.groups.count(), [&](int g) {
    add_group(g, x, {}, std::span(terms).subspan(g * term_count(), term_count()));
  });
  PotentialTerms total = sum(terms);
  if (model_.collision) total.contacts = model_.collision->add(x, nullptr, nullptr);
  return total;
}

void IncrementalPotential::add_mass(int group, double weight, GroupBands bands) const {
  const Pack* mass = &model_.mass[model_.groups[group].first_row];
  for (int i = 0; i < bands.rows(); ++i) {
    for (int c = 0; c < 3; ++c) bands.block(i, 0)(c, c) += weight * mass[i];
  }
}

IncrementalPotential::Assembled IncrementalPotential::assemble(
    const VertexField& x, VertexField& gradient, SystemMatrix& matrix, LinearSolver& solver,
    VertexField& direction, double added) const {
  double contacts = 0;
  if (model_.collision) {
    gradient.set_zero();
    matrix.couplings.clear();
    contacts = model_.collision->add(x, &gradient, &matrix.couplings);
    matrix.couplings.finish(model_.free);
  }
  const bool keep_all = solver.keeps_bands();
  if (keep_all || matrix.couples_strands()) matrix.keep_bands();
  std::vector<double> terms(model_.groups.count() * term_count());
  std::vector<double> squared_gradients(model_.groups.count());
  parallel_for_each(model_.groups.count(), [&](int g) {
    const bool coupled = matrix.couplings.touches(g);
    const GroupBands bands =
        keep_all || coupled ? matrix.bands.group(g) : matrix.temporary_bands(g);
    bands.set_zero();
    const auto rows = gradient.group(g);
    if (model_.collision) {
      matrix.couplings.add_to_bands(g, bands);
    } else {
      std::fill(rows.begin(), rows.end(), Vector3<Pack>{0, 0, 0});
    }
    add_group(g, x, {rows, bands}, std::span(terms).subspan(g * term_count(), term_count()));
    if (added != 0) add_mass(g, added, bands);
    const std::span free = std::span(model_.free).subspan(model_.groups[g].first_row, bands.rows());
    squared_gradients[g] = pin_gradient(rows, free);
    pin_rows(bands, free);
    solver.prepare_group({g, bands, rows, coupled}, direction.group(g));
  });
  Assembled result{sum(terms)};
  result.terms.contacts = contacts;
  result.squared_gradient =
      std::accumulate(squared_gradients.begin(), squared_gradients.end(), 0.0);
  return result;
}

std::optional<std::string> find_non_finite(const Model& model, const VertexField& x) {
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    if (!x.get(v).allFinite()) return "the position of " + name_of(model, v) + " is not finite";
  }
  for (std::size_t e = 0; e < model.energies.size(); ++e) {
    auto found = find_non_finite_term(model, x, *model.energies[e], model.energy_names[e]);
    if (found) return found;
  }
  for (std::size_t f = 0; f < model.forces.size(); ++f) {
    const std::string name = "force number " + std::to_string(f + 1);
    if (auto found = find_non_finite_term(model, x, *model.forces[f], name)) return found;
  }
  if (model.collision) {
    VertexField gradient(model.groups);
    const double value = model.collision->add(x, &gradient, nullptr);
    for (int v = 0; v < model.strands.vertex_count(); ++v) {
      if (std::isfinite(value) && gradient.get(v).allFinite()) continue;
      return "the contact energy, or its gradient at " + name_of(model, v) + ", is not finite";
    }
  }
  return std::nullopt;
}

}  // namespace ringlet
