#include "plugins/run_frames.h"

#include <optional>

#include "core/error.h"
#include "plugins/frames/frames_reader.h"
#include "plugins/vtp/pvd.h"
#include "plugins/vtp/vtp_reader.h"

namespace ringlet {

namespace fs = std::filesystem;

class RunFrames::Source {
 public:
  virtual ~Source() = default;
  virtual RunFrame read(int number) = 0;

  std::vector<int> vertex_counts;
  std::vector<double> radii;
  std::vector<int> steps;
  std::vector<std::string> left_out;
};

namespace {

class BinaryFrames final : public RunFrames::Source {
 public:
  explicit BinaryFrames(const fs::path& path) : reader_(path) {
    vertex_counts = reader_.header().vertex_counts;
    radii = reader_.radii();
    for (int i = 0; i < reader_.count(); ++i) {
      steps.push_back(static_cast<int>(reader_.step(i)));
    }
    if (steps.empty()) throw Error("'" + path.string() + "' holds no whole frame");
  }

  RunFrame read(int number) override {
    StoredFrame frame = reader_.read(number);
    return {static_cast<int>(frame.step), frame.time, std::move(frame.positions)};
  }

 private:
  FramesReader reader_;
};

class VtpFrames final : public RunFrames::Source {
 public:
  explicit VtpFrames(std::vector<FrameFile> files) : files_(std::move(files)) {
    std::optional<VtpFrame> last;
    while (!files_.empty() && !(last = read_or_leave_out(files_.back()))) files_.pop_back();
    for (const FrameFile& file : files_) steps.push_back(file.step);
    if (!last) return;
    offsets_ = last->offsets;
    radii.assign(last->radii.begin(), last->radii.end());
    int first = 0;
    for (const int end : offsets_) {
      vertex_counts.push_back(end - first);
      first = end;
    }
  }

  RunFrame read(int number) override {
    const FrameFile& file = files_.at(static_cast<std::size_t>(number));
    const VtpFrame frame = read_vtp_frame(file.path);
    if (frame.offsets != offsets_) {
      throw Error("'" + file.path.string() + "' is of other strands than the last frame");
    }
    const Eigen::Map<const Eigen::Matrix3Xf> points(
        frame.points.data(), 3, static_cast<Eigen::Index>(frame.points.size() / 3));
    return {file.step, frame.time, points.cast<double>()};
  }

 private:
  std::optional<VtpFrame> read_or_leave_out(const FrameFile& file) {
    try {
      return read_vtp_frame(file.path);
    } catch (const Error& error) {
      left_out.push_back(error.what());
      return {};
    }
  }

  std::vector<FrameFile> files_;
  std::vector<std::int32_t> offsets_;
};

}  // namespace

RunFrames::RunFrames(const fs::path& run) {
  const bool is_folder = fs::is_directory(run);
  if (const fs::path file = is_folder ? run / "frames.bin" : run;
      file.extension() == ".bin" && fs::exists(file)) {
    source_ = std::make_unique<BinaryFrames>(file);
    return;
  }
  source_ =
      std::make_unique<VtpFrames>(is_folder ? list_frame_files(run, "vtp") : list_pvd_frames(run));
  if (!source_->steps.empty()) return;
  throw Error("'" + run.string() +
              "' has no frame; expected frames.bin or frames/frame_<step>.vtp, which a scene "
              "writes with \"run\": {\"write\": [\"frames\"]} or [\"vtp\"]" +
              (source_->left_out.empty() ? "" : ". " + source_->left_out.front()));
}

RunFrames::~RunFrames() = default;

const std::vector<int>& RunFrames::vertex_counts() const { return source_->vertex_counts; }
const std::vector<double>& RunFrames::radii() const { return source_->radii; }
const std::vector<int>& RunFrames::steps() const { return source_->steps; }
const std::vector<std::string>& RunFrames::left_out() const { return source_->left_out; }

RunFrame RunFrames::read(int number) { return source_->read(number); }

}  // namespace ringlet
