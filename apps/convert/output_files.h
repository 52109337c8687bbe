#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ringlet {

/// A format of files that frames can be converted to, by the extension of its files.
struct OutputFormat {
  std::string extension;
  std::string writer;  ///< that makes it
  std::string file;    ///< of all frames in the folder of the writer; "": a file a frame
};

/// Throws Error for an extension that is not known.
OutputFormat output_format(const std::filesystem::path& out);

/// A file that a writer makes in its folder, and where it is to go.
struct OutputFile {
  std::filesystem::path made, wanted;
};

/// All that a conversion makes. A file a frame is OUT itself where there is only one frame, else
/// OUT_<step>; the index of a .pvd comes last.
std::vector<OutputFile> output_files(const OutputFormat& format, const std::filesystem::path& out,
                                     const std::vector<int>& steps);

/// Throws Error if any of the files is there already.
void refuse_to_overwrite(const std::vector<OutputFile>& files);

/// A new folder beside a file, which is gone at the end of its scope.
class FolderBeside {
 public:
  /// Throws Error if it cannot be made.
  explicit FolderBeside(const std::filesystem::path& file);
  ~FolderBeside();
  FolderBeside(const FolderBeside&) = delete;
  FolderBeside& operator=(const FolderBeside&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace ringlet
