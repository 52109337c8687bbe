#include "tests/solvers/test_model.h"

#include "core/read_choice.h"
#include "solvers/modules.h"
#include "tests/catch.h"
#include "tests/solvers/random_system.h"

namespace ringlet {

double PointTerm::add(int group, std::span<const Vector3<Pack>> x, GroupOutputs outputs) const {
  double energy = 0;
  const int first_row = (*groups_)[group].first_row;
  for (int i = 0; i < static_cast<int>(x.size()); ++i) {
    for (int lane = 0; lane < lane_count; ++lane) {
      const int vertex = groups_->vertex_at(first_row + i, lane);
      if (vertex < 0) continue;
      const PointValue point = function_(vertex, {x[i].x[lane], x[i].y[lane], x[i].z[lane]});
      energy += point.value;
      const auto add_to = [lane](Pack& pack, double value) { pack[lane] = pack[lane] + value; };
      if (!outputs.gradient.empty()) {
        add_to(outputs.gradient[i].x, point.gradient.x());
        add_to(outputs.gradient[i].y, point.gradient.y());
        add_to(outputs.gradient[i].z, point.gradient.z());
      }
      if (outputs.hessian.empty()) continue;
      for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) {
          add_to(outputs.hessian.block(i, 0)(r, c), point.hessian(r, c));
        }
      }
    }
  }
  return energy;
}

void Weight::bind(const Strands& strands, const StrandGroups& groups) {
  term_ = std::make_unique<PointTerm>([&strands, this](int vertex, const Eigen::Vector3d& x) {
    const Eigen::Vector3d weight = strands.mass(vertex) * acceleration_;
    return PointValue{-weight.dot(x), -weight, Eigen::Matrix3d::Zero()};
  });
  term_->bind(groups);
}

void Springs::bind(const Strands& strands, const StrandGroups& groups) {
  groups_ = &groups;
  rest_ = VertexField(groups);
  edge_stiffness_.assign(groups.rows(), Pack(0));
  for (int v = 0; v + 1 < strands.vertex_count(); ++v) {
    if (strands.strand_of(v) != strands.strand_of(v + 1)) continue;
    const auto [row, lane] = groups.slot(v);
    edge_stiffness_[row][lane] = stiffness_;
    rest_.set(v, strands.rest_position(v + 1) - strands.rest_position(v));
  }
}

double Springs::add(int group, std::span<const Vector3<Pack>> x, EdgeOutputs outputs) const {
  Pack energy = 0;
  const Pack* stiffness = &edge_stiffness_[(*groups_)[group].first_row];
  for (int i = 0; i + 1 < static_cast<int>(x.size()); ++i) {
    const Vector3<Pack> stretch = x[i + 1] - x[i] - rest_.group(group)[i];
    energy += 0.5 * stiffness[i] * squared_norm(stretch);
    if (!outputs.gradient.empty()) outputs.gradient[i] += stiffness[i] * stretch;
    if (outputs.hessian.empty()) continue;
    for (int c = 0; c < 3; ++c) outputs.hessian.block(i, 0)(c, c) += stiffness[i];
  }
  return sum_lanes(energy);
}

namespace {

std::vector<Eigen::Vector3d> rest_positions(const Model& model) {
  std::vector<Eigen::Vector3d> positions;
  for (int v = 0; v < model.strands.vertex_count(); ++v) {
    positions.push_back(model.strands.rest_position(v));
  }
  return positions;
}

}  // namespace

std::unique_ptr<Model> make_model(const std::vector<int>& vertex_counts, bool pin_roots) {
  auto model = std::make_unique<Model>(straight_strands(vertex_counts));
  std::vector<Pin> pins;
  for (int strand = 0; pin_roots && strand < model->strands.count(); ++strand) {
    pins.push_back({model->strands.first(strand), ""});
  }
  model->set_pins(pins, rest_positions(*model));
  model->solver = make_solver("strand_cholesky");
  model->solver->bind(model->groups);
  return model;
}

void add_energy(Model& model, std::unique_ptr<Energy> energy) {
  energy->bind(model.strands, model.groups);
  energy->set_name("energy " + std::to_string(model.energies.size()));
  model.energies.push_back(std::move(energy));
}

void add_force(Model& model, std::unique_ptr<Force> force) {
  force->bind(model.strands, model.groups);
  force->set_name("force " + std::to_string(model.forces.size()));
  model.forces.push_back(std::move(force));
}

State rest_state(const Model& model) {
  return {0, positions_with_pads(model.groups, rest_positions(model)), VertexField(model.groups)};
}

std::unique_ptr<Integrator> make_integrator(const Registry& registry, const Json& json,
                                            const Model& model) {
  auto integrator = make_chosen<Integrator>(registry, json);
  integrator->bind(model);
  return integrator;
}

std::unique_ptr<Integrator> make_integrator(const Json& json, const Model& model) {
  Registry registry;
  register_solvers(registry);
  return make_integrator(registry, json, model);
}

}  // namespace ringlet
