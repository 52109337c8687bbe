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

/// The elastic energy of strands and couplings, J.
double elastic_energy(const Model& model, const VertexField& positions);

/// Whether energy comes from nowhere: watches kinetic, elastic and contact energy together.
class EnergyWatch {
 public:
  /// From a state on; what contacts it has is not counted.
  EnergyWatch(const Model& model, const State& state);
  /// The largest rise from one step to the next so far, as a part of the largest energy so far.
  double rise_after(const StepReport& report);

 private:
  double last_, largest_;
  double rise_ = 0;
};

/// A step and what was seen of it.
struct StepSample {
  int step;
  double time;     ///< s, simulated
  double seconds;  ///< that the step took
  const StepReport& report;
  RestDistance rest_distance;
  double energy_rise = 0;  ///< of an EnergyWatch
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
