#pragma once

#include <string>
#include <vector>

#include "apps/commands/command.h"

namespace ringlet {

/// The text of `ringlet help`.
std::string help_text(const std::vector<Command>& commands);

}  // namespace ringlet
