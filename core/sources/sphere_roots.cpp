// Roots on a sphere or on half of one, spread as blue noise; strands grow outwards.
#include <Eigen/Geometry>

#include "core/direction.h"
#include "core/registry.h"
#include "core/sources/blue_noise.h"
#include "core/strand_source.h"

namespace ringlet {
namespace {

struct Sphere {
  double radius = 1;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();

  static Schema<Sphere> schema() {
    return Schema<Sphere>()
        .required("radius", &Sphere::radius, "m", positive(), "of the sphere")
        .key("centre", &Sphere::centre, "m", any_number(), "of the sphere");
  }
};

struct Hemisphere {
  Sphere sphere;
  Direction up;

  static Schema<Hemisphere> schema() {
    return Schema<Hemisphere>()
        .include(&Hemisphere::sphere)
        .key("up", &Hemisphere::up, "", any_number(),
             "points to the middle of the half that is used");
  }
};

class SphereRoots final : public RootSource {
 public:
  SphereRoots(const Sphere& sphere, const Eigen::Vector3d& up, double lowest)
      : sphere_(sphere), up_(up), lowest_(lowest) {}

  std::vector<Root> place(int count, unsigned seed) const override {
    const auto rotation = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitY(), up_);
    std::vector<Root> roots;
    for (const Eigen::Vector3d& point : blue_noise_on_sphere(count, lowest_, seed)) {
      const Eigen::Vector3d normal = rotation * point;
      roots.push_back({sphere_.centre + sphere_.radius * normal, normal});
    }
    return roots;
  }

 private:
  Sphere sphere_;
  Eigen::Vector3d up_;
  double lowest_;  // height of the lowest root on the unit sphere
};

}  // namespace

void register_sphere_roots(Registry& registry) {
  const std::string source =
      "C. Yuksel, Sample Elimination for Generating Poisson Disk Sample Sets, CGF 34(2), 2015";
  registry.of<RootSource>().add<Sphere>(
      "sphere", {"blue noise on a sphere; strands grow outwards", "", source},
      [](const Sphere& sphere) {
        return std::make_unique<SphereRoots>(sphere, Eigen::Vector3d::UnitY(), -1);
      });
  registry.of<RootSource>().add<Hemisphere>(
      "hemisphere", {"blue noise on half of a sphere; strands grow outwards", "", source},
      [](const Hemisphere& half) {
        return std::make_unique<SphereRoots>(half.sphere, half.up.unit, 0);
      });
}

}  // namespace ringlet
