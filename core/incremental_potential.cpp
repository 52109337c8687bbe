#include "core/incremental_potential.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/parallel.h"
#include "core/registry.h"

namespace ringlet {
namespace {

/// So many rows of a group are completed and factored at a time, while they are in the nearest
/// cache.
constexpr int rows_at_a_time = 8;

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

/// term(group, positions, GroupOutputs) returns a value and adds derivatives.
template <class Term>
std::optional<std::string> find_non_finite_term(const Model& model, const VertexField& x,
                                                const Term& term, const std::string& name) {
  for (int g = 0; g < model.groups.count(); ++g) {
    const auto [first_row, vertices, strands] = model.groups[g];
    std::vector<Vector3<Pack>> gradient(vertices, {0, 0, 0});
    std::vector<Matrix3<Pack>> blocks(vertices * band_blocks, Matrix3<Pack>::zero());
    const GroupBands hessian{std::span(blocks)};
    const double value = term(g, x.group(g), {gradient, hessian});
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

/// Of what adds couplings: a CouplingEnergy or a CollisionStage.
template <class Term>
std::optional<std::string> find_non_finite_coupling(const Model& model, const VertexField& x,
                                                    Term& term, const std::string& what) {
  VertexField gradient(model.groups);
  Couplings couplings(model.groups);
  const double value = term.add(x, &couplings);
  couplings.finish(model.free);
  for (int g = 0; g < model.groups.count(); ++g) couplings.add_gradient(g, gradient.group(g));
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    if (std::isfinite(value) && gradient.get(v).allFinite()) continue;
    return what + ", or its gradient at " + name_of(model, v) + ", is not finite";
  }
  return std::nullopt;
}

bool is_held(std::span<const Pack> free) {
  return std::all_of(free.begin(), free.end(),
                     [](const Pack& lanes) { return std::experimental::none_of(lanes != 0); });
}

/// Makes rows of the gradient zero where nothing is free; returns their squared norm.
double pin_gradient(std::span<Vector3<Pack>> gradient, RowRange rows, std::span<const Pack> free) {
  Pack squared = 0;
  for (int i = rows.first; i < rows.end; ++i) {
    gradient[i] = free[i] * gradient[i];
    squared += squared_norm(gradient[i]);
  }
  return sum_lanes(squared);
}

bool has_hessian(const Force& force) { return force.has_hessian(); }

}  // namespace

double PotentialTerms::total() const {
  return inertia + forces + contacts + std::accumulate(energies.begin(), energies.end(), 0.0) +
         std::accumulate(couplings.begin(), couplings.end(), 0.0);
}

double PotentialTerms::magnitude() const {
  double sum = std::abs(inertia) + std::abs(forces) + std::abs(contacts);
  for (const double energy : energies) sum += std::abs(energy);
  for (const double coupling : couplings) sum += std::abs(coupling);
  return sum;
}

IncrementalPotential::IncrementalPotential(const Model& model, const VertexField& inertial_target,
                                           double h)
    : model_(model),
      target_(inertial_target),
      terms_of_groups_(model.groups.count() * term_count()),
      of_groups_(model.groups.count()),
      coupling_values_(model.couplings.size()) {
  set_effective_step(h);
}

double IncrementalPotential::inertia(int group, ConstRows x) const {
  const auto target = target_.group(group);
  const Pack* mass = &model_.mass[model_.groups[group].first_row];
  Pack sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += mass[i] * squared_norm(x[i] - target[i]);
  return 0.5 * inverse_h2_ * sum_lanes(sum);
}

void IncrementalPotential::add_energies(int group, ConstRows x, EdgeOutputs outputs,
                                        std::span<double> terms) const {
  for (std::size_t e = 0; e < model_.energies.size(); ++e) {
    const Energy& energy = *model_.energies[e];
    terms[e + 1] = naming(energy, sample_of(group), [&] { return energy.add(group, x, outputs); });
  }
}

TimeSample IncrementalPotential::sample_of(int group) const {
  constexpr int enough = 32;
  const int count = model_.groups.count(), stride = std::max(count / enough, 1);
  if (group % stride != 0) return std::nullopt;
  const int measured = (count + stride - 1) / stride;
  return static_cast<double>(count) / measured;
}

template <class IsWanted>
void IncrementalPotential::add_forces(int group, ConstRows x, GroupOutputs outputs,
                                      std::span<double> terms, const IsWanted& is_wanted) const {
  for (const auto& force : model_.forces) {
    if (!is_wanted(*force)) continue;
    terms.back() += naming(*force, sample_of(group), [&] { return force->add(group, x, outputs); });
  }
}

void IncrementalPotential::sum_terms(PotentialTerms& total) const {
  total.inertia = total.forces = 0;
  total.energies.assign(model_.energies.size(), 0.0);
  for (int g = 0; g < model_.groups.count(); ++g) {
    const auto terms = terms_of(g);
    total.inertia += terms.front();
    for (std::size_t e = 0; e < total.energies.size(); ++e) total.energies[e] += terms[e + 1];
    total.forces += terms.back();
  }
  total.couplings = coupling_values_;
  total.contacts = contact_value_;
}

void IncrementalPotential::value_of_group(int group, ConstRows x) {
  const std::span of_group = writable_terms(group);
  of_group.front() = inertia(group, x);
  of_group.back() = 0;
  add_energies(group, x, {}, of_group);
  add_forces(group, x, {}, of_group, [](const Force&) { return true; });
}

PinnedRows IncrementalPotential::pinned_rows(int group) const {
  const auto rows_of = [&](const auto& all) {
    return std::span(all).subspan(model_.groups[group].first_row, model_.groups[group].vertices);
  };
  return {rows_of(model_.free), rows_of(model_.has_pins)};
}

void IncrementalPotential::value(const VertexField& x, PotentialTerms& terms) {
  parallel_for_each(model_.groups.count(), [&](int g) { value_of_group(g, x.group(g)); });
  add_coupled(x, nullptr);
  sum_terms(terms);
}

void IncrementalPotential::couple(const VertexField& x, SystemMatrix& matrix) {
  matrix.couplings.clear();
  add_coupled(x, &matrix.couplings);
  matrix.couplings.finish(model_.free);
}

void IncrementalPotential::add_coupled(const VertexField& x, Couplings* couplings) {
  for (std::size_t i = 0; i < coupling_values_.size(); ++i) {
    const CouplingEnergy& coupling = *model_.couplings[i];
    coupling_values_[i] = naming(coupling, [&] { return coupling.add(x, couplings); });
  }
  if (!model_.collision) return;
  CollisionStage& collision = *model_.collision;
  contact_value_ = naming(collision, [&] { return collision.add(x, couplings); });
}

void IncrementalPotential::assemble(const VertexField& x, VertexField& gradient,
                                    SystemMatrix& matrix, LinearSolver& solver,
                                    VertexField& direction, Assembled& result, double added) {
  if (solver.band_factor() == nullptr) matrix.keep_bands();
  parallel_for_each(model_.groups.count(), [&](int g) {
    const GroupRows rows{x.group(g), gradient.group(g), direction.group(g), added};
    of_groups_[g] = assemble_group(g, rows, matrix, solver);
  });
  sum_terms(result.terms);
  result.squared_gradient = 0;
  result.usable = true;
  for (const GroupAssembled& of_group : of_groups_) {
    result.squared_gradient += of_group.squared_gradient;
    result.usable &= of_group.usable;
  }
}

IncrementalPotential::GroupAssembled IncrementalPotential::assemble_group(int group,
                                                                          const GroupRows& rows,
                                                                          SystemMatrix& matrix,
                                                                          LinearSolver& solver) {
  const auto& [x, gradient, direction, added] = rows;
  std::fill(gradient.begin(), gradient.end(), Vector3<Pack>{0, 0, 0});
  const bool keep_bands = solver.band_factor() == nullptr;
  GroupAssembled result{.usable = true};
  if (!keep_bands && is_held(pinned_rows(group).free)) {
    value_of_group(group, x);
    std::fill(direction.begin(), direction.end(), Vector3<Pack>{0, 0, 0});
    return result;
  }
  const GroupOutputs outputs{
      gradient, keep_bands ? matrix.bands.group(group) : matrix.temporary_bands(group)};
  const GroupSystem system{group, outputs.hessian, gradient, matrix.couplings.touches(group)};
  const std::span terms = writable_terms(group);
  terms.back() = terms.front() = 0;
  matrix.couplings.add_gradient(group, gradient);
  add_forces(group, x, {gradient, {}}, terms, std::not_fn(has_hessian));
  EdgeDerivatives& edges = matrix.temporary_edges(group);
  add_energies(group, x, edges.outputs(), terms);

  const RowRange all{0, outputs.hessian.rows()};
  if (has_edges_only(group, matrix.couplings)) {
    for (int first = 0; first < all.end; first += rows_at_a_time) {
      const RowRange some{first, std::min(first + rows_at_a_time, all.end)};
      terms.front() += write_rows(group, some, rows, edges, outputs.hessian);
      prepare_rows(system, some, rows, solver, result);
    }
  } else {
    terms.front() = write_rows(group, all, rows, edges, outputs.hessian);
    add_forces(group, x, outputs, terms, has_hessian);
    matrix.couplings.add_to_bands(group, outputs.hessian);
    prepare_rows(system, all, rows, solver, result);
  }
  return result;
}

bool IncrementalPotential::has_edges_only(int group, const Couplings& couplings) const {
  return !couplings.has_part_in(group) &&
         std::none_of(model_.forces.begin(), model_.forces.end(),
                      [](const auto& force) { return has_hessian(*force); });
}

double IncrementalPotential::write_rows(int group, RowRange range, const GroupRows& rows,
                                        EdgeDerivatives& edges, GroupBands hessian) const {
  const auto target = target_.group(group);
  const Pack* mass = &model_.mass[model_.groups[group].first_row];
  const double mass_weight = inverse_h2_ + rows.added;
  Pack inertia = 0;
  for (int i = range.first; i < range.end; ++i) {
    const Vector3<Pack> apart = rows.x[i] - target[i];
    inertia += mass[i] * squared_norm(apart);
    Matrix3<Pack>* row = &hessian.block(i, 0);
    const Vector3<Pack> elastic = edges.take_row(i, row);
    rows.gradient[i] += elastic + Pack(inverse_h2_ * mass[i]) * apart;
    for (int c = 0; c < 3; ++c) (*row)(c, c) += mass_weight * mass[i];
  }
  return 0.5 * inverse_h2_ * sum_lanes(inertia);
}

void IncrementalPotential::prepare_rows(const GroupSystem& system, RowRange range,
                                        const GroupRows& rows, LinearSolver& solver,
                                        GroupAssembled& result) const {
  const PinnedRows pinned = pinned_rows(system.group);
  result.squared_gradient += pin_gradient(rows.gradient, range, pinned.free);
  if (!result.usable) return;
  pin_rows(system.bands, range, pinned);
  result.usable = naming(solver, sample_of(system.group),
                         [&] { return solver.prepare_rows(system, range, rows.direction); });
}

std::optional<std::string> find_non_finite(const Model& model, const VertexField& x) {
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    if (!x.get(v).allFinite()) return "the position of " + name_of(model, v) + " is not finite";
  }
  for (std::size_t e = 0; e < model.energies.size(); ++e) {
    const auto add = [&](int g, std::span<const Vector3<Pack>> rows, const GroupOutputs& outputs) {
      return add_at_vertices(*model.energies[e], g, rows, outputs);
    };
    if (auto found = find_non_finite_term(model, x, add, model.energies[e]->name())) return found;
  }
  for (std::size_t f = 0; f < model.forces.size(); ++f) {
    const auto add = [&](int g, std::span<const Vector3<Pack>> rows, const GroupOutputs& outputs) {
      return model.forces[f]->add(g, rows, outputs);
    };
    if (auto found = find_non_finite_term(model, x, add, model.forces[f]->name())) return found;
  }
  for (const auto& coupling : model.couplings) {
    const std::string what = "the value of '" + coupling->name() + "'";
    if (auto found = find_non_finite_coupling(model, x, *coupling, what)) return found;
  }
  if (!model.collision) return std::nullopt;
  return find_non_finite_coupling(model, x, *model.collision, "the contact energy");
}

}  // namespace ringlet
