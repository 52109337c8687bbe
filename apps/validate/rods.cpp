// Planar rods, clamped at one end, in equilibrium.

#include <array>
#include <cmath>

#include "apps/validate/end_moment.h"
#include "apps/validate/statics.h"

namespace ringlet {
namespace {

constexpr double length = 1;  // of the free part, m

/// From the clamp, which is vertex 1, to the tip, m.
Eigen::Vector3d clamp_to_tip(const Simulation& simulation) {
  const VertexField& x = simulation.state().positions;
  return x.get(simulation.model().strands.vertex_count() - 1) - x.get(1);
}

double bending_stiffness(const Json& scene) {
  const double radius = scene["material"]["radius"];
  return scene["material"]["youngs_modulus"].get<double>() * pi * std::pow(radius, 4) / 4;
}

double droop_over_reach(double gamma, int edges, const Registry& registry) {
  Json scene = validation_scene("cantilever");
  set_clamped_edges(scene, edges, length);
  // Gamma = w L^3 / B = 4 rho g L^3 / (E r^2)
  Json& material = scene["material"];
  const double radius = material["radius"], density = material["density"];
  material["youngs_modulus"] = 4 * density * 9.81 * std::pow(length, 3) / (gamma * radius * radius);
  const Eigen::Vector3d d = clamp_to_tip(*run_scene(scene, registry));
  return -d.y() / d.x();
}

struct BentTip {
  double angle_degrees, droop, shortening;
};

struct TipLoad {
  double a;  ///< P L^2 / B
  BentTip exact;
};

BentTip bend_by_tip_load(double a, int edges, const Registry& registry) {
  Json scene = validation_scene("elastica");
  set_clamped_edges(scene, edges, length);
  const double load = a * bending_stiffness(scene) / (length * length);
  scene["forces"][0]["force"] = {0, -load, 0};
  const auto simulation = run_scene(scene, registry);
  const Eigen::Vector3d d = clamp_to_tip(*simulation);
  const VertexField& x = simulation->state().positions;
  const int tip = simulation->model().strands.vertex_count() - 1;
  const Eigen::Vector3d last = x.get(tip) - x.get(tip - 1);
  return {std::atan2(-last.y(), last.x()) * 180 / pi, -d.y() / length, (length - d.x()) / length};
}

/// How far a column's head is from upright, as a part of its length.
double lean_of(const Json& scene, const Registry& registry) {
  const Eigen::Vector3d d = clamp_to_tip(*run_scene(scene, registry));
  return std::hypot(d.x(), d.z()) / length;
}

/// How far the middle of a column between two clamps is from the line between them, as a part of
/// its length, when one of them has come nearer by what the load makes the column shorter.
double bow_of_clamped(double part_of_euler, const Registry& registry) {
  Json scene = validation_scene("clamped_column");
  const double radius = scene["material"]["radius"];
  // P L / (EA) with P = 4 pi^2 B / L^2, B = E A r^2 / 4
  const double nearer = part_of_euler * pi * pi * radius * radius / length;
  scene["motions"]["press"][0]["translations"][1] = {0, -nearer, 0};
  const auto simulation = run_scene(scene, registry);
  const int middle = simulation->model().strands.vertex_count() / 2;
  return simulation->state().positions.get(middle).head<1>().norm() / length;
}

}  // namespace

void validate_cantilever(const Registry& registry, const ValidationOptions& options,
                         const ValidationOutput& output) {
  struct Droop {
    double gamma, ratio;
  };
  constexpr std::array<Droop, 9> droops{{{1, 0.124562},
                                         {2, 0.246673},
                                         {5, 0.585721},
                                         {10, 1.066802},
                                         {20, 1.863930},
                                         {50, 3.705561},
                                         {100, 5.888105},
                                         {200, 8.906771},
                                         {1000, 21.335440}}};
  for (const auto& [gamma, ratio] : droops) {
    if (options.quick && gamma != 1 && gamma != 100) continue;
    ValidationRow row{"cantilever", "droop / reach at Gamma = " + std::to_string(int(gamma)), ratio,
                      droop_over_reach(gamma, 100, registry), 5e-3};
    if (gamma == 1) {
      const double coarse = droop_over_reach(gamma, 12, registry),
                   fine = droop_over_reach(gamma, 24, registry);
      row.order = observed_order(std::abs(coarse - ratio), std::abs(fine - ratio));
      row.least_order = 1.8;
    }
    output(row);
  }
}

void validate_elastica(const Registry& registry, const ValidationOptions& options,
                       const ValidationOutput& output) {
  constexpr std::array<TipLoad, 5> loads{{{0.5, {14.01075, 0.162144, 0.015919}},
                                          {1, {26.43352, 0.301721, 0.056433}},
                                          {2, {44.79097, 0.493457, 0.160642}},
                                          {5, {69.63546, 0.713792, 0.387628}},
                                          {10, {81.94932, 0.810609, 0.554996}}}};
  for (const TipLoad& load : loads) {
    if (options.quick && load.a != 2) continue;
    const BentTip bent = bend_by_tip_load(load.a, 100, registry);
    const BentTip coarse = bend_by_tip_load(load.a, 12, registry),
                  fine = bend_by_tip_load(load.a, 24, registry);
    const std::string at = ", a = " + Json(load.a).dump();
    const double order = observed_order(std::abs(coarse.droop - load.exact.droop),
                                        std::abs(fine.droop - load.exact.droop));
    output({"elastica", "angle of the tip, degrees" + at, load.exact.angle_degrees,
            bent.angle_degrees, 5e-3});
    output({"elastica", "droop / L" + at, load.exact.droop, bent.droop, 5e-3, order, 1.8});
    output({"elastica", "shortening / L" + at, load.exact.shortening, bent.shortening, 5e-3});
  }
}

void validate_ring(const Registry& given, const ValidationOptions&,
                   const ValidationOutput& output) {
  Registry registry = given;
  register_end_moment(registry);
  Json scene = validation_scene("elastica");
  set_clamped_edges(scene, 40, length);
  scene["forces"] = {{{"type", "end_moment"}, {"moment", 2 * pi * bending_stiffness(scene)}}};
  scene["energies"] = {"stretch", {{"type", "bending"}, {"filter", "exact"}}};
  scene["run"]["steps"] = 12;
  const Eigen::Vector3d d = clamp_to_tip(*run_scene(scene, registry));
  output({"ring", "distance of the ends / L", 0, d.norm() / length, 1e-6});
}

void validate_buckling(const Registry& registry, const ValidationOptions&,
                       const ValidationOutput& output) {
  const Json column = validation_scene("column");
  const double euler = pi * pi * bending_stiffness(column) / (4 * length * length);
  const auto under_load = [&](double part) {
    Json scene = column;
    set_clamped_edges(scene, 100, length);
    scene["forces"][0]["force"] = {0, -part * euler, 0};
    return lean_of(scene, registry);
  };
  // w L^3 / B = 4 rho g L^3 / (E r^2)
  constexpr double greenhill = 7.837347;
  const auto under_weight = [&](double part) {
    Json scene = column;
    set_clamped_edges(scene, 100, length);
    Json& material = scene["material"];
    const double radius = material["radius"], density = material["density"];
    material["youngs_modulus"] =
        4 * density * 9.81 * std::pow(length, 3) / (part * greenhill * radius * radius);
    scene["forces"] = {"gravity"};
    return lean_of(scene, registry);
  };
  output({"buckling", "lean of the head / L, 0.97 of Euler's load", 0, under_load(0.97), 1e-3});
  output({"buckling", "buckled (1) at 1.03 of Euler's load", 1, under_load(1.03) > 0.1 ? 1.0 : 0.0,
          0});
  output({"buckling", "bow between two clamps / L, 0.97 of Euler's load", 0,
          bow_of_clamped(0.97, registry), 1e-3});
  output({"buckling", "bowed (1) at 1.03 of it", 1,
          bow_of_clamped(1.03, registry) > 2e-3 ? 1.0 : 0.0, 0});
  output({"buckling", "lean of the head / L, 0.97 of Greenhill's weight", 0, under_weight(0.97),
          1e-3});
  output({"buckling", "buckled (1) at 1.03 of Greenhill's weight", 1,
          under_weight(1.03) > 0.1 ? 1.0 : 0.0, 0});
}

}  // namespace ringlet
