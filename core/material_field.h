#pragma once

#include "core/material.h"
#include "core/varying.h"

namespace ringlet {

/// The material of all strands: as Material, but it may differ from place to place.
struct MaterialField {
  Varying youngs_modulus;
  std::optional<Varying> shear_modulus;
  double poisson_ratio;
  Varying density;
  Varying radius;
  std::optional<double> tip_radius;

  MaterialField() : MaterialField(Material{}) {}
  MaterialField(const Material& material)  // NOLINT(*-explicit-*)
      : youngs_modulus(material.youngs_modulus),
        shear_modulus(material.shear_modulus),
        poisson_ratio(material.poisson_ratio),
        density(material.density),
        radius(material.radius),
        tip_radius(material.tip_radius) {}

  static Schema<MaterialField> schema();
  /// In the middle between two vertices of a strand.
  Material between_vertices(const Strands& strands, int a, int b) const;
  /// With the taper towards the tip, m.
  double radius_at(const Strands& strands, int vertex) const;
};

}  // namespace ringlet
