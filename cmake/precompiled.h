// Compiled once for all libraries: what nearly every source file includes, and is slow to read.
#include <Eigen/Geometry>

#include "core/model.h"
#include "core/registry.h"
