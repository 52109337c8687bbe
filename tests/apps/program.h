#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "core/parameters.h"
#include "tests/temporary_folder.h"

namespace ringlet {

/// What a run of the program did.
struct ProgramResult {
  int exit_code = -1;
  std::string output;  ///< of stdout
  std::string errors;  ///< of stderr
};

/// Runs the program `ringlet` as a user would, in a folder of its own that is removed at the end.
class Workplace {
 public:
  const std::filesystem::path& folder() const { return folder_.path(); }
  /// Writes a file into the folder and returns its name.
  std::string write(const std::string& name, const std::string& text) const;
  ProgramResult run(const std::vector<std::string>& arguments) const;
  /// Starts the program, sends it a signal when metrics.csv in the given folder has that many
  /// lines, and waits for its end.
  ProgramResult run_and_signal(const std::vector<std::string>& arguments,
                               const std::string& results, int lines, int signal) const;

 private:
  int start(const std::vector<std::string>& arguments) const;
  ProgramResult finish(int process) const;

  TemporaryFolder folder_;
};

std::string read_text(const std::filesystem::path& path);
int count_lines(const std::string& text);
/// Name and bytes of every file in a folder.
std::map<std::string, std::string> read_files(const std::filesystem::path& folder);
/// The columns of a metrics.csv by name.
std::map<std::string, std::vector<double>> read_metrics(const std::filesystem::path& path);

/// A scene of a few curls that runs in an instant, for changes.
Json small_scene();

}  // namespace ringlet
