#pragma once

#include <algorithm>
#include <vector>

#include "collision/contact.h"
#include "core/bytes.h"
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
  void add_terms(Couplings& couplings) {
    int terms_so_far = 0;
    first_terms_.clear();
    for (const auto& part : parts_) {
      first_terms_.push_back(terms_so_far);
      terms_so_far += static_cast<int>(part.size());
    }
    const std::span<CouplingTerm> terms = couplings.append(terms_so_far);
    parallel_for_each(static_cast<int>(parts_.size()), [&](int p) {
      int term = first_terms_[p];
      for (const auto& [candidate, contact] : parts_[p]) terms[term++] = contact.term();
    });
  }

  std::size_t bytes() const { return bytes_of(parts_) + bytes_of(first_terms_); }

 private:
  std::vector<std::vector<Found>> parts_;  // those without candidates are kept for later
  std::vector<int> first_terms_;           // of each part
};

}  // namespace ringlet
