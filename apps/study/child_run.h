#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace ringlet {

/// How a run of this program as a child ended.
struct ChildOutcome {
  int exit_code = -1;   ///< of apps/exit_codes.h; -1: a signal ended it
  std::string message;  ///< what it said about a failure
};

/// Runs `ringlet run SCENE -o FOLDER` with so many threads as a process of its own, so that nothing
/// it does can harm this one, and waits for its end. Where stop() becomes true meanwhile, the child
/// is asked to end after its step. Throws Error if it cannot be started.
ChildOutcome run_as_child(const std::filesystem::path& scene, const std::filesystem::path& folder,
                          int threads, const std::function<bool()>& stop);

}  // namespace ringlet
