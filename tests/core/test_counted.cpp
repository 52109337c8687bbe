#include "core/counted.h"
#include "core/vector3.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("a counted number counts the operations that it takes part in") {
  std::int64_t count = 0;
  const Counted a(3, count), b(4, count);
  CHECK(sqrt(a * a + b * b).value() == 5);
  CHECK(count == 4);
  CHECK((-max(abs(a), b)).value() == -4);
  CHECK(count == 4);
  const Counted doubled = Counted(1) + Counted(1);
  CHECK(count == 4);
  CHECK((doubled / a).value() == 2.0 / 3);
  CHECK(count == 5);
}

TEST_CASE("counted vectors cost what their formulas do") {
  std::int64_t count = 0;
  const auto vector = [&count](double x, double y, double z) {
    return Vector3<Counted>{{x, count}, {y, count}, {z, count}};
  };
  const Vector3<Counted> a = vector(1, 2, 3), b = vector(4, 5, 6);
  CHECK(dot(a, b).value() == 32);
  CHECK(count == 5);
  CHECK(cross(a, b).z.value() == -3);
  CHECK(count == 5 + 9);
}
