#include "apps/study/study_results.h"

#include <spdlog/fmt/fmt.h>

#include "apps/study/front.h"

namespace ringlet {
namespace {

/// With an error and a time: only what ran to its end, and did not explode, takes part.
std::optional<TradePoint> trade_point(const Json& variant, const std::string& error) {
  const bool counts = variant["status"] == "finished" || variant["status"] == "not_converged";
  if (!counts || variant["seconds"].is_null() || variant["errors"][error].is_null()) {
    return std::nullopt;
  }
  return TradePoint{variant["name"], variant["seconds"], variant["errors"][error]};
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + '"';
}

std::string cell(const Json& value) {
  if (value.is_null()) return "";
  return value.is_string() ? quoted(value.get<std::string>()) : value.dump();
}

}  // namespace

void add_fronts(Json& results) {
  results["fronts"] = results["recommendations"] = Json::object();
  for (const Json& error : results["errors"]) {
    const std::string name = error["name"];
    std::vector<TradePoint> points;
    std::optional<TradePoint> as_it_stands;
    for (const Json& variant : results["variants"]) {
      const auto point = trade_point(variant, name);
      if (!point) continue;
      points.push_back(*point);
      if (variant["name"] == results["default"]) as_it_stands = point;
    }
    const auto front = pareto_front(std::move(points));
    if (front.empty()) continue;
    for (const TradePoint& point : front) results["fronts"][name].push_back(point.name);
    results["recommendations"][name] = recommend(front, as_it_stands, error["unit"]);
  }
}

std::string to_csv(const Json& results) {
  std::string text = "name";
  for (const Json& axis : results["axes"]) text += "," + quoted(axis["name"]);
  const std::vector<const char*> rest{"status",
                                      "verdict",
                                      "reason",
                                      "seconds",
                                      "seconds_low",
                                      "seconds_high",
                                      "steps",
                                      "newton_iterations",
                                      "linear_iterations",
                                      "steps_not_converged",
                                      "peak_memory_bytes"};
  for (const char* column : rest) text += std::string(",") + column;
  for (const Json& error : results["errors"]) text += ",error_" + error["name"].get<std::string>();
  text += ",run\n";
  for (const Json& variant : results["variants"]) {
    text += cell(variant["name"]);
    for (const Json& axis : results["axes"]) {
      text += "," + cell(variant["values"].value(axis["name"].get<std::string>(), Json()));
    }
    for (const char* column : rest) text += "," + cell(variant[column]);
    for (const Json& error : results["errors"]) {
      text += "," + cell(variant["errors"][error["name"].get<std::string>()]);
    }
    text += "," + cell(variant["run"]) + "\n";
  }
  return text;
}

}  // namespace ringlet
