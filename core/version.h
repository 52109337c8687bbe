#pragma once

namespace ringlet {

/// Of ringlet; the build takes it from here.
inline constexpr const char* version = "0.1.0";

}  // namespace ringlet
