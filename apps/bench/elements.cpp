// What an element costs: each energy with each filter, in lanes and one by one.

#include "apps/bench/element_timing.h"
#include "core/batch_energy.h"

namespace ringlet {

void bench_elements(const Registry& registry, const BenchOptions& options, BenchOutput& output) {
  constexpr double nano = 1e-9;
  output.start_table(
      "An element with gradient and filtered Hessian, ns on one thread; the baseline is the "
      "numeric "
      "clamp in plain doubles, one element after the other",
      {{"energy", "/parameters/energy"},
       {"filter", "/parameters/filter"},
       {"evaluation", "/parameters/evaluation"},
       {"ns an element", "/seconds", nano},
       {"spread", "/spread", nano},
       {"baseline takes x times as long", "/ratio"}});
  for (const std::string& name : registry.of<Energy>().names()) {
    const EnergyMaker make = energy_maker(registry, name);
    const double baseline =
        time_element(make, {{"filter", "clamp"}, {"evaluation", "scalar"}}, options).median;
    for (const auto& [filter, filter_name] : EnumNames<Filter>::names) {
      for (const auto& [evaluation, evaluation_name] : EnumNames<Evaluation>::names) {
        const Json keys{{"filter", filter_name}, {"evaluation", evaluation_name}};
        if (make(keys) == nullptr) continue;  // no filter of this energy
        const Timing timing = time_element(make, keys, options);
        Json parameters{{"energy", name}};
        parameters.update(keys);
        output.add({.name = "elements",
                    .parameters = parameters,
                    .time = timing,
                    .ratio = baseline / timing.median});
      }
    }
  }
}

}  // namespace ringlet
