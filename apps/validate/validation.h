#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/registry.h"

namespace ringlet {

/// A quantity with a closed-form value, and what a simulation gives for it.
struct ValidationRow {
  std::string name;  ///< of the case
  std::string quantity;
  double expected;
  double measured;
  double tolerance;  ///< of the error relative to the expected value, or absolute where that is 0
  /// p of an error that falls as (1 / vertices)^p, seen under refinement, and the least it may be.
  std::optional<double> order = {}, least_order = {};

  double error() const;
  bool passes() const;
};

struct ValidationOptions {
  bool quick = false;  ///< coarser, where that suffices for the tolerance
};

/// Where a case puts its rows.
using ValidationOutput = std::function<void(const ValidationRow&)>;

/// A problem of strands whose answer is known.
struct ValidationCase {
  const char* name;
  const char* summary;
  const char* source;
  void (*run)(const Registry&, const ValidationOptions&, const ValidationOutput&);
};

/// All of them.
std::vector<ValidationCase> all_validation_cases();

void validate_cantilever(const Registry& registry, const ValidationOptions& options,
                         const ValidationOutput& output);
void validate_elastica(const Registry& registry, const ValidationOptions& options,
                       const ValidationOutput& output);
void validate_ring(const Registry& registry, const ValidationOptions& options,
                   const ValidationOutput& output);
void validate_buckling(const Registry& registry, const ValidationOptions& options,
                       const ValidationOutput& output);
void validate_wire(const Registry& registry, const ValidationOptions& options,
                   const ValidationOutput& output);
void validate_catenary(const Registry& registry, const ValidationOptions& options,
                       const ValidationOutput& output);
void validate_spring(const Registry& registry, const ValidationOptions& options,
                     const ValidationOutput& output);
void validate_cantilever_modes(const Registry& registry, const ValidationOptions& options,
                               const ValidationOutput& output);
void validate_chain_modes(const Registry& registry, const ValidationOptions& options,
                          const ValidationOutput& output);
void validate_free_fall(const Registry& registry, const ValidationOptions& options,
                        const ValidationOutput& output);
void validate_rigid_motion(const Registry& registry, const ValidationOptions& options,
                           const ValidationOutput& output);
void validate_incline(const Registry& registry, const ValidationOptions& options,
                      const ValidationOutput& output);
void validate_capstan(const Registry& registry, const ValidationOptions& options,
                      const ValidationOutput& output);
void validate_sag_free(const Registry& registry, const ValidationOptions& options,
                       const ValidationOutput& output);

/// A scene of apps/scenes/validation, which the program carries along.
Json validation_scene(const std::string& name);

}  // namespace ringlet
