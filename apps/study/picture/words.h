#pragma once

#include <string>

#include "apps/study/picture/data.h"

namespace ringlet {

/// The points of the front that bear a number, in its order: evenly among all if they are many.
std::vector<std::size_t> numbered_front(const PictureData& data);

/// Commands that write what stands around the plot: name, what it is about, the default and the
/// front in words, what colours and symbols mean, and at the foot what is not shown and how times
/// were taken.
std::string words_around(const PictureData& data);

}  // namespace ringlet
