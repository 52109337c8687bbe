#include <set>

#include "core/metrics.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("metrics have different names, also of two energies of one type") {
  std::set<std::string> names;
  const auto metrics = list_metrics({"bending", "twist", "bending", "bending"});
  for (const Metric& metric : metrics) names.insert(metric.name);
  CHECK(names.size() == metrics.size());
  for (const char* name :
       {"energy_bending", "energy_twist", "energy_bending_2", "energy_bending_3"}) {
    CHECK(names.contains(name));
  }
}

TEST_CASE("energies are measured by their place, contacts as a sum") {
  StepReport report;
  report.energies = {1, 2, 3};
  report.contacts = {4, 5, 0.5};
  const StepSample sample{7, 0.25, 0.001, report, {}};
  for (const Metric& metric : list_metrics({"bending", "twist", "bending"})) {
    const double value = metric.value(sample);
    if (metric.name == "energy_bending_2") CHECK(value == 3);
    if (metric.name == "energy_twist") CHECK(value == 2);
    if (metric.name == "contacts") CHECK(value == 9);
    if (metric.name == "step_ms") CHECK(value == 1);
  }
}

TEST_CASE("the distance to the rest shape is relative to each strand's length") {
  // Lengths 1 m and 2 m; each tip is moved by 0.1 m.
  const std::vector<Eigen::Vector3d> rest{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  const Model model(Strands({2, 3}, rest, {}));
  std::vector<Eigen::Vector3d> moved = rest;
  moved[1].y() += 0.1;
  moved[4].z() -= 0.1;
  const RestDistance distance =
      measure_rest_distance(model, positions_with_pads(model.groups, moved));
  CHECK(distance.mean == Approx((0.1 + 0.05) / 5));
  CHECK(distance.max == Approx(0.1));
}

TEST_CASE("energy that comes from nowhere is watched, in parts of the largest so far") {
  const std::vector<Eigen::Vector3d> rest{{0, 0, 0}, {1, 0, 0}};
  Model model(Strands({2}, rest, {}));
  model.mass.assign(model.groups.rows(), Pack(2));
  State state{0, positions_with_pads(model.groups, rest), VertexField(model.groups)};
  state.velocities.set(0, {3, 0, 0});
  EnergyWatch watch(model, state);  // 9 J
  StepReport report;
  report.energies = {4, 2};
  report.contact_energy = 1;
  report.kinetic_energy = 1;
  CHECK(watch.rise_after(report) == 0);  // 8 J
  report.kinetic_energy = 3;
  CHECK(watch.rise_after(report) == Approx(2.0 / 10));  // 10 J
  report.kinetic_energy = 4;
  CHECK(watch.rise_after(report) == Approx(2.0 / 10));  // 11 J: a smaller rise
  report.kinetic_energy = 33;
  CHECK(watch.rise_after(report) == Approx(29.0 / 40));
}
