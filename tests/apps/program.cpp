#include "tests/apps/program.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace ringlet {

namespace fs = std::filesystem;

std::string Workplace::write(const std::string& name, const std::string& text) const {
  std::ofstream(folder() / name) << text;
  return name;
}

int Workplace::start(const std::vector<std::string>& arguments) const {
  std::vector<std::string> words{RINGLET_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  const std::string output = folder() / "stdout.txt", errors = folder() / "stderr.txt";
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, output.c_str(), flags, 0600);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, errors.c_str(), flags, 0600);
  posix_spawn_file_actions_addchdir_np(&actions, folder().c_str());
  pid_t process = -1;
  const int error = posix_spawn(&process, argv[0], &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::runtime_error("cannot start " + words[0]);
  return process;
}

ProgramResult Workplace::finish(int process) const {
  int status = 0;
  waitpid(process, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(folder() / "stdout.txt"),
          read_text(folder() / "stderr.txt")};
}

ProgramResult Workplace::run(const std::vector<std::string>& arguments) const {
  return finish(start(arguments));
}

ProgramResult Workplace::run_and_signal(const std::vector<std::string>& arguments,
                                        const std::string& results, int lines, int signal) const {
  const int process = start(arguments);
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (count_lines(read_text(folder() / results / "metrics.csv")) < lines) {
    if (std::chrono::steady_clock::now() > give_up) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  kill(process, signal);
  return finish(process);
}

std::string read_text(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

int count_lines(const std::string& text) {
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

std::map<std::string, std::string> read_files(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.is_regular_file()) files[entry.path().filename()] = read_text(entry.path());
  }
  return files;
}

std::map<std::string, std::vector<double>> read_metrics(const fs::path& path) {
  std::map<std::string, std::vector<double>> columns;
  std::istringstream text(read_text(path));
  std::vector<std::string> names;
  for (std::string line; std::getline(text, line);) {
    std::istringstream cells(line);
    std::size_t column = 0;
    const bool is_head = names.empty();
    for (std::string cell; std::getline(cells, cell, ','); ++column) {
      if (is_head) {
        names.push_back(cell);
      } else {
        columns[names.at(column)].push_back(cell.empty() ? std::nan("") : std::stod(cell));
      }
    }
    if (column != names.size()) throw std::runtime_error("a ragged line in " + path.string());
  }
  return columns;
}

Json small_scene() {
  return Json::parse(R"({
    "strands": {"type": "helix", "count": 20, "vertices": 15, "stem_vertices": 3,
                "random_turn": true, "pinned": 4,
                "roots": {"type": "row", "direction": [1, 0, 0], "spacing": [0, 0.004, 0]}},
    "material": {"youngs_modulus": 6e7, "density": 65, "radius": 2e-3},
    "energies": ["stretch", "bending", "twist"],
    "forces": ["gravity"],
    "collision": {"type": "fcl", "thickness": 1e-3, "stiffness": 2},
    "solver": {"type": "pcg", "preconditioner": "strand_cholesky"},
    "run": {"steps": 6, "write": ["vtp"]}
  })");
}

}  // namespace ringlet
