#include "core/energy.h"
#include "core/named.h"
#include "core/registry.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("what a plugin throws is told with its kind and name") {
  CHECK(naming<Energy>("soft", [] { return 3; }) == 3);
  CHECK_THROWS_WITH(naming<Energy>("soft", [] { throw std::runtime_error("no luck"); }),
                    "energy 'soft': no luck");
  CHECK_THROWS_AS(naming<Energy>("soft", [] { throw 3; }), PluginError);
}

TEST_CASE("the innermost plugin is named, and a lack of memory is nobody's fault") {
  CHECK_THROWS_WITH(
      naming<Integrator>("outer", [] { naming<Energy>("inner", [] { throw Error("no luck"); }); }),
      "energy 'inner': no luck");
  CHECK_THROWS_AS(naming<Energy>("soft", [] { throw std::bad_alloc(); }), std::bad_alloc);
}
