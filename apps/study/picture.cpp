#include "apps/study/picture.h"

#include "apps/study/picture/child_program.h"
#include "apps/study/picture/script.h"
#include "core/atomic_file.h"
#include "core/error.h"

namespace ringlet {

void draw_study(const Json& results, const std::filesystem::path& png) {
  // Without the reader's own settings, which may change the picture.
  const auto drawn = run_program({"gnuplot", "-d"}, picture_script(results));
  if (!drawn) {
    throw Error(
        "gnuplot was not found, which draws the picture of a study. Install it (Debian: "
        "gnuplot-nox)");
  }
  if (drawn->exit_code != 0 || !drawn->output.starts_with("\x89PNG")) {
    throw Error("gnuplot could not draw the picture of a study: " + drawn->errors);
  }
  AtomicFile file(png);
  file.stream() << drawn->output;
  file.commit();
}

}  // namespace ringlet
