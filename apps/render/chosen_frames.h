#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ringlet {

/// The numbers of the frames that a user asks for by their steps: `frame` is one step; `range`, as
/// "A:B" or "A:B:EVERY", those from step A to B whose distance from A is a multiple of EVERY. With
/// neither it is the last one. `steps` are those there are, ascending, one or more. Throws Error if
/// both are given, if there is no such frame, or if the text is not of this form.
std::vector<int> chosen_frames(const std::vector<int>& steps, std::optional<int> frame,
                               const std::optional<std::string>& range);

}  // namespace ringlet
