#pragma once

#include "apps/study/study_file.h"

namespace ringlet {

/// The parts of results.json that follow from its variants: of each error the Pareto front and what
/// it recommends.
void add_fronts(Json& results);

/// results.csv: a row a variant.
std::string to_csv(const Json& results);

}  // namespace ringlet
