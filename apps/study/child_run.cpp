#include "apps/study/child_run.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>
#include <vector>

#include "core/error.h"

namespace ringlet {
namespace {

namespace fs = std::filesystem;

constexpr auto between_looks = std::chrono::milliseconds(5);

class SpawnActions {
 public:
  explicit SpawnActions(const fs::path& log) {
    posix_spawn_file_actions_init(&files_);
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_addopen(&files_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files_, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&files_, STDERR_FILENO, log.c_str(),
                                     O_WRONLY | O_CREAT | O_TRUNC, 0644);
    // Ctrl-C reaches this program alone, which passes it on.
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes_, 0);
  }
  ~SpawnActions() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;

  const posix_spawn_file_actions_t* files() const { return &files_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

pid_t start(std::vector<std::string> words, const fs::path& log) {
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const SpawnActions actions(log);
  pid_t child = -1;
  const int error = posix_spawn(&child, "/proc/self/exe", actions.files(), actions.attributes(),
                                arguments.data(), environ);
  if (error != 0) throw Error(std::string("a run cannot be started: ") + std::strerror(error));
  return child;
}

int wait_for(pid_t child, const std::function<bool()>& stop) {
  bool is_asked = false;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (stop() && !is_asked) {
      kill(child, SIGINT);
      is_asked = true;
    }
    std::this_thread::sleep_for(between_looks);
  }
  return status;
}

/// What follows "error: " in the lines of a log.
std::string errors_in(const fs::path& log) {
  std::ifstream file(log);
  std::string errors;
  for (std::string line; std::getline(file, line);) {
    const std::string mark = "error: ";
    const std::size_t at = line.find(mark);
    if (at == std::string::npos) continue;
    errors += (errors.empty() ? "" : "; ") + line.substr(at + mark.size());
  }
  return errors;
}

}  // namespace

ChildOutcome run_as_child(const fs::path& scene, const fs::path& folder, int threads,
                          const std::function<bool()>& stop) {
  const fs::path log = folder.string() + ".log";
  const pid_t child = start({"ringlet", "run", scene.string(), "-o", folder.string(), "--quiet",
                             "--threads", std::to_string(threads)},
                            log);
  const int status = wait_for(child, stop);
  const std::string errors = errors_in(log);
  if (WIFEXITED(status)) return {WEXITSTATUS(status), errors};
  const char* name = strsignal(WTERMSIG(status));
  return {-1, std::string("ended by a signal: ") + (name != nullptr ? name : "unknown") +
                  (errors.empty() ? "" : "; " + errors)};
}

}  // namespace ringlet
