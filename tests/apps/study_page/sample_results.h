#pragma once

#include "core/parameters.h"

namespace ringlet {

/// Results of a study with five variants: one finished, two not converged, one exploded, one
/// refused.
Json sample_results();

/// A variant that finished, on the front of no error.
Json sample_variant(const std::string& name, double seconds, double error);

}  // namespace ringlet
