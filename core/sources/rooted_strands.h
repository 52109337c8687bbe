#pragma once

#include <span>

#include "core/registry.h"
#include "core/strand_source.h"

namespace ringlet {

/// Parameters that all generated strands have: how many, how fine, where they stand, how they are
/// held.
struct RootedStrands {
  int count = 1;
  int vertices = 101;
  Choice<RootSource> roots = "point";
  int pinned = 2;
  MotionName motion;
  int seed = 1;

  static Schema<RootedStrands> schema();
};

/// Whether each strand is turned about its own axis by a random angle.
enum class Turn { none, random };

/// Puts a copy of a shape on each root. The shape is given for a root at the origin that grows
/// along +y, m; the smallest rotation that takes +y to the direction of a root carries it there.
StrandSet grow_strands(const RootedStrands& strands, std::span<const Eigen::Vector3d> shape,
                       Turn turn);

}  // namespace ringlet
