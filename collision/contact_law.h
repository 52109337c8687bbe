#pragma once

#include "core/contact_energy.h"

namespace ringlet {

/// A contact energy with its numbers.
struct ContactLaw {
  const ContactEnergy* energy;
  double thickness;  ///< m
  double stiffness;  ///< N/m

  DistanceEnergy at(double distance) const { return energy->at(distance, thickness, stiffness); }
};

}  // namespace ringlet
