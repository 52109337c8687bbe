#include "apps/run_replay.h"

#include <map>
#include <string>
#include <utility>

#include "core/error.h"

namespace ringlet {

RecordedStep recorded_step(std::span<const Metric> metrics, std::span<const double> row) {
  StepReport report;
  std::map<std::string, double> cells;
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    const std::string& name = metrics[i].name;
    cells[name] = row[i];
    if (name.starts_with("energy_") && name != "energy_rise") report.energies.push_back(row[i]);
  }
  report.newton_converged = cells["newton_converged"] != 0;
  report.linear_converged = cells["linear_converged"] != 0;
  report.local_error_met = cells["local_error_met"] != 0;
  report.kinetic_energy = cells["kinetic_energy"];
  report.contact_energy = cells["contact_energy"];
  report.seconds = {1e-3 * cells["detect_ms"], 1e-3 * cells["couple_ms"],
                    1e-3 * cells["evaluate_ms"], 1e-3 * cells["solve_ms"],
                    1e-3 * cells["line_search_ms"]};
  return {std::move(report), 1e-3 * cells["step_ms"]};
}

std::vector<std::vector<double>> read_rows(const MetricsTable& table,
                                           std::span<const Metric> metrics, int steps) {
  bool is_same = table.names.size() == metrics.size();
  for (std::size_t i = 0; is_same && i < metrics.size(); ++i) {
    is_same = table.names[i] == metrics[i].name;
  }
  if (!is_same) throw Error("metrics.csv has other columns than this scene");
  if (table.rows() < static_cast<std::size_t>(steps)) {
    throw Error("metrics.csv has " + std::to_string(table.rows()) + " steps; expected " +
                std::to_string(steps));
  }
  std::vector<std::vector<double>> rows(static_cast<std::size_t>(steps));
  for (std::size_t step = 0; step < rows.size(); ++step) {
    for (const auto& column : table.columns) rows[step].push_back(column[step]);
  }
  return rows;
}

}  // namespace ringlet
