#pragma once

#include <algorithm>
#include <vector>

#include "collision/contact.h"
#include "core/parallel.h"

namespace ringlet {

/// The candidates that touch, found in parallel, in the order of the candidates.
class Touching {
 public:
  struct Found {
    int candidate;
    Contact contact;
  };

  /// Forgets the last ones; find(part, found) appends what touches of each part of the candidates.
  template <class Find>
  void collect(int parts, const Find& find) {
    for (auto& part : parts_) part.clear();
    if (static_cast<int>(parts_.size()) < parts) parts_.resize(parts);
    parallel_for_each(parts, [&](int p) { find(p, parts_[p]); });
  }

  int count() const {
    int sum = 0;
    for (const auto& part : parts_) sum += static_cast<int>(part.size());
    return sum;
  }
  /// visit(candidate, contact).
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const auto& part : parts_) {
      for (const auto& [candidate, contact] : part) visit(candidate, contact);
    }
  }
  double energy() const {
    double sum = 0;
    for_each([&](int, const Contact& contact) { sum += contact.energy.value; });
    return sum;
  }
  /// The largest depth, m; 0 if nothing touches.
  double depth() const {
    double largest = 0;
    for_each([&](int, const Contact& contact) { largest = std::max(largest, contact.depth); });
    return largest;
  }
  void add_terms(Couplings& couplings) const {
    const std::span<CouplingTerm> terms = couplings.append(count());
    std::size_t next = 0;
    for_each([&](int, const Contact& contact) { terms[next++] = contact.term(); });
  }

 private:
  std::vector<std::vector<Found>> parts_;  // those without candidates are kept for later
};

}  // namespace ringlet
