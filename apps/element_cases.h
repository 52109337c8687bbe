#pragma once

#include <optional>

#include "core/energy.h"
#include "core/registry.h"

namespace ringlet {

/// Evaluates elements one by one. The input is {"cases": [{"energy": NAME, "positions": [[x, y, z],
/// ...], "stiffness": k, "rest": length or angle}, ...]}; keys beyond these are passed over. The
/// result has, case by case, `energy`, `value`, `gradient` and the exact `hessian`, and with a
/// filter its `filtered`. Throws InvalidInput with every problem of the input.
Json evaluate_cases(const Registry& registry, const Json& input,
                    const std::optional<std::string>& filter);

}  // namespace ringlet
