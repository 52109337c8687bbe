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
    sums_.resize(parts_.size());
    parallel_for_each(static_cast<int>(parts_.size()), [&](int p) {
      if (p < parts) find(p, parts_[p]);
      sums_[p].energies.clear();
      sums_[p].depth = 0;
      for (const auto& [candidate, contact] : parts_[p]) {
        sums_[p].energies.push_back(contact.energy.value);
        sums_[p].depth = std::max(sums_[p].depth, contact.depth);
      }
    });
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
  /// Added up contact by contact: candidates that do not touch leave the bits of it alone.
  double energy() const {
    double sum = 0;
    for (const Sums& part : sums_) {
      for (const double energy : part.energies) sum += energy;
    }
    return sum;
  }
  /// The largest depth, m; 0 if nothing touches.
  double depth() const {
    double largest = 0;
    for (const Sums& part : sums_) largest = std::max(largest, part.depth);
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

  std::size_t bytes() const {
    std::size_t sum = bytes_of(parts_) + bytes_of(sums_) + bytes_of(first_terms_);
    for (const Sums& part : sums_) sum += bytes_of(part.energies);
    return sum;
  }

 private:
  /// What is summed over the contacts of a part, while they are warm in cache.
  struct Sums {
    std::vector<double> energies;
    double depth = 0;
  };

  std::vector<std::vector<Found>> parts_;  // those without candidates are kept for later
  std::vector<Sums> sums_;                 // of each part
  std::vector<int> first_terms_;           // of each part
};

}  // namespace ringlet
