#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ringlet {

/// A variant as the trade sees it.
struct TradePoint {
  std::string name;
  double seconds;
  double error;
};

/// The Pareto front: those than which no other is as fast and as accurate, and better in one of
/// both. The fastest first.
std::vector<TradePoint> pareto_front(std::vector<TradePoint> points);

/// What to take, in words: for bounds on the error from loose to tight (1, 0.3, 0.1, ... of its
/// unit), the fastest point of the front that keeps it, where that changes; compared with the scene
/// as it stands, if that was measured.
std::vector<std::string> recommend(const std::vector<TradePoint>& front,
                                   const std::optional<TradePoint>& as_it_stands,
                                   const std::string& unit);

}  // namespace ringlet
