#include <spdlog/fmt/fmt.h>

#include <cstdio>

#include "apps/commands/command.h"
#include "apps/exit_codes.h"
#include "apps/overrides.h"
#include "core/energy.h"
#include "core/verify/verify_energy.h"

namespace ringlet {
namespace {

void print_claim(const Claim& claim) {
  fmt::print("  {:<55} {:>9.1e} {:>9.0e} {:>6}  {}\n", claim.text, claim.worst, claim.allowed,
             claim.states, claim.holds() ? "ok" : "FAILED: " + claim.worst_state);
}

/// Prints the table of an energy; returns how many claims do not hold.
int verify_one(const Registry& registry, const Json& choice, const VerifyOptions& options) {
  const std::vector<Claim> claims = verify_energy(energy_maker(registry, choice), options);
  fmt::print("{}\n  {:<55} {:>9} {:>9} {:>6}\n", choice["type"].get<std::string>(), "claim",
             "worst", "allowed", "states");
  int failed = 0;
  for (const Claim& claim : claims) {
    print_claim(claim);
    failed += claim.holds() ? 0 : 1;
  }
  return failed;
}

int verify(const Registry& registry, const Arguments& arguments) {
  VerifyOptions options;
  options.seed = static_cast<std::uint64_t>(arguments.integer("--seed", 0).value_or(1));
  options.trials = arguments.integer("--trials", 1).value_or(options.trials);
  const auto wanted = arguments.operand(0);
  if (!wanted && arguments.has("--set")) {
    throw Error("--set changes a key of one energy; say which: ringlet verify NAME");
  }
  std::vector<std::string> names = registry.of<Energy>().names();
  if (wanted) names = {*wanted};
  int failed = 0;
  for (const std::string& name : names) {
    Json choice{{"type", name}};
    for (const std::string& assignment : arguments.values("--set")) {
      apply_override(choice, assignment);
    }
    failed += verify_one(registry, choice, options);
  }
  fmt::print("seed {}, {} trials of each state; {}\n", options.seed, options.trials,
             failed == 0 ? "all claims hold" : fmt::format("{} claims do not hold", failed));
  return failed == 0 ? exit_ok : exit_unexpected;
}

}  // namespace

Command verify_command() {
  return {"verify",
          {"[NAME]"},
          "tries everything an energy, or every energy, promises; exit code 1 if it fails",
          {{.name = "--seed", .value = "N", .meaning = "of the random states; 1 if absent"},
           {.name = "--trials", .value = "N", .meaning = "random states of each kind; 6 if absent"},
           {.name = "--set",
            .value = "/KEY=VALUE",
            .meaning = "a parameter of the energy; may be repeated",
            .repeatable = true}},
          verify};
}

}  // namespace ringlet
