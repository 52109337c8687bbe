#pragma once

#include "core/model.h"
#include "core/named.h"

namespace ringlet {

/// Chooses the rest state of the elements of a model's energies, which is at first that of the
/// strands' shape.
class RestState : public Named {
 public:
  virtual ~RestState() = default;
  /// Returns an empty report where there is nothing to hold. Throws Error with the reason if it
  /// cannot.
  virtual RestReport choose(Model& model) const = 0;
};

}  // namespace ringlet
