#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/model.h"
#include "core/step_report.h"

namespace ringlet {

/// How far the strands are from their rest shape: distances of the vertices to their rest
/// positions, each divided by the rest length of its strand.
struct RestDistance {
  double mean = 0;
  double max = 0;
};
RestDistance measure_rest_distance(const Model& model, const VertexField& positions);

/// A step and what was seen of it.
struct StepSample {
  int step;
  double time;     ///< s, simulated
  double seconds;  ///< that the step took
  const StepReport& report;
  RestDistance rest_distance;
};

/// A quantity that is measured after every step: a column of metrics.csv, and what a scene's
/// "expect" may speak of.
struct Metric {
  std::string name;
  std::function<double(const StepSample&)> value;
};

/// All metrics of a run whose energies have these types, in the order of metrics.csv. The second
/// energy of a type "bending" is the metric energy_bending_2. Those that are left out are zero.
std::vector<Metric> list_metrics(const std::vector<std::string>& energy_types,
                                 const std::vector<std::string>& left_out = {});

}  // namespace ringlet
