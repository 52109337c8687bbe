#include "apps/study/picture/child_program.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/error.h"

namespace ringlet {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
/// Has no name and is gone when it is closed. Unlike a pipe it never makes a program wait.
using TemporaryFile = std::unique_ptr<std::FILE, CloseFile>;

TemporaryFile make_temporary() {
  TemporaryFile file(std::tmpfile());
  if (!file) throw Error(std::string("no temporary file can be made: ") + std::strerror(errno));
  return file;
}

TemporaryFile make_temporary(const std::string& text) {
  TemporaryFile file = make_temporary();
  const bool written = std::fwrite(text.data(), 1, text.size(), file.get()) == text.size();
  if (!written || std::fflush(file.get()) != 0) {
    throw Error(std::string("a temporary file cannot be written: ") + std::strerror(errno));
  }
  std::rewind(file.get());
  return file;
}

std::string read_all(std::FILE* file) {
  std::rewind(file);
  std::string text;
  char piece[4096];
  for (std::size_t count; (count = std::fread(piece, 1, sizeof piece, file)) > 0;) {
    text.append(piece, count);
  }
  return text;
}

class FileActions {
 public:
  FileActions() { posix_spawn_file_actions_init(&actions_); }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  void use(std::FILE* file, int descriptor) {
    posix_spawn_file_actions_adddup2(&actions_, fileno(file), descriptor);
  }
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

std::optional<ProgramOutput> run_program(const std::vector<std::string>& words,
                                         const std::string& input) {
  const TemporaryFile in = make_temporary(input), out = make_temporary(), err = make_temporary();
  FileActions actions;
  actions.use(in.get(), STDIN_FILENO);
  actions.use(out.get(), STDOUT_FILENO);
  actions.use(err.get(), STDERR_FILENO);
  std::vector<std::string> own = words;
  std::vector<char*> arguments;
  for (std::string& word : own) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int failure =
      posix_spawnp(&child, arguments[0], actions.get(), nullptr, arguments.data(), environ);
  if (failure == ENOENT) return std::nullopt;
  if (failure != 0) throw Error("'" + words[0] + "' cannot be started: " + std::strerror(failure));
  const int exit_code = wait_for(child);
  return ProgramOutput{exit_code, read_all(out.get()), read_all(err.get())};
}

}  // namespace ringlet
