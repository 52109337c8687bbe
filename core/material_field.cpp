#include "core/material_field.h"

#include "core/strands.h"

namespace ringlet {

Schema<MaterialField> MaterialField::schema() {
  using M = MaterialField;
  return Schema<M>()
      .key("youngs_modulus", &M::youngs_modulus, "Pa", at_least(0), "Young's modulus E")
      .key("shear_modulus", &M::shear_modulus, "Pa", at_least(0),
           "shear modulus G; E / 2(1 + poisson_ratio) if absent")
      .key("poisson_ratio", &M::poisson_ratio, "", between(-1, 0.5),
           "only used where shear_modulus is absent")
      .key("density", &M::density, "kg/m^3", positive(), "mass per volume")
      .key("radius", &M::radius, "m", positive(), "of the cross-section, at the root")
      .key("tip_radius", &M::tip_radius, "m", positive(),
           "of the cross-section at the tip; that of the root if absent")
      .check([](M& material, const std::string& pointer, ParseContext& context) {
        if (material.tip_radius && !material.radius.is_constant_along()) {
          context.problem(pointer_to(pointer, "tip_radius"),
                          "not expected beside a radius that varies along the strands itself");
        }
        // Where one number says it, an echo of the scene does so.
        const Json modulus = Codec<Varying>::write(material.youngs_modulus);
        const Json root_radius = Codec<Varying>::write(material.radius);
        if (!material.shear_modulus && modulus.is_number()) {
          const Material plain{.youngs_modulus = modulus.get<double>(),
                               .poisson_ratio = material.poisson_ratio};
          material.shear_modulus = plain.shear();
        }
        if (!material.tip_radius && root_radius.is_number())
          material.tip_radius = root_radius.get<double>();
      });
}

Material MaterialField::between_vertices(const Strands& strands, int a, int b) const {
  const auto mean = [&](const Varying& number) {
    return 0.5 * (number.at(strands, a) + number.at(strands, b));
  };
  Material material;
  material.youngs_modulus = mean(youngs_modulus);
  if (shear_modulus) material.shear_modulus = mean(*shear_modulus);
  material.poisson_ratio = poisson_ratio;
  material.density = mean(density);
  material.radius = 0.5 * (strands.radius(a) + strands.radius(b));
  return material;
}

double MaterialField::radius_at(const Strands& strands, int vertex) const {
  const double root = radius.at(strands, vertex);
  if (!tip_radius) return root;
  return root + (*tip_radius - root) * strands.fraction_along(vertex);
}

}  // namespace ringlet
