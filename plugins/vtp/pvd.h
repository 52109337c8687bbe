#pragma once

#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "plugins/frame_files.h"

namespace ringlet {

/// A frame in the index of a sequence of .vtp files.
struct PvdEntry {
  double time;       ///< s
  std::string file;  ///< relative to the folder of the index
};

/// Writes a .pvd, VTK's XML Collection, which ParaView opens.
void write_pvd(const std::vector<PvdEntry>& entries, std::ostream& stream);

/// Reads one. Throws Error if it is not whole.
std::vector<PvdEntry> read_pvd(const std::filesystem::path& path);

/// The files of one. Their steps are the numbers at the end of their names, or where these do not
/// ascend, as in that of another program, their places from 0 on. Throws Error as read_pvd().
std::vector<FrameFile> list_pvd_frames(const std::filesystem::path& path);

}  // namespace ringlet
