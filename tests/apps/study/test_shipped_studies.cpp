#include "apps/study/variant.h"
#include "collision/modules.h"
#include "core/modules.h"
#include "energies/modules.h"
#include "plugins/modules.h"
#include "solvers/modules.h"
#include "tests/catch.h"

using namespace ringlet;

TEST_CASE("every shipped study makes variants, and none is refused unless it says so") {
  Registry registry;
  register_core(registry);
  register_energies(registry);
  register_solvers(registry);
  register_collision(registry);
  register_plugins(registry);
  int studies = 0;
  for (const auto& entry : std::filesystem::directory_iterator(RINGLET_STUDIES)) {
    if (entry.path().extension() != ".json") continue;
    CAPTURE(entry.path().string());
    ++studies;
    const StudyFile study = read_study_file(entry.path());
    const StudyVariants all = make_variants(study, entry.path().parent_path(), registry);
    CHECK(all.variants.size() > 3);
    CHECK_FALSE(study.about.empty());
    for (const Variant& variant : all.variants) {
      CAPTURE(variant.name, variant.refusal);
      CHECK((variant.refusal.empty() || variant.name.find("refused") != std::string::npos));
    }
    if (study.reference) CHECK(all.reference->refusal.empty());
  }
  CHECK(studies >= 6);
}
