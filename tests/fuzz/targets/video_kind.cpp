#include "core/video/file_kind.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

/// What is said of a file that does not open as a video.
ABRAZO_FUZZ_TARGET(video_kind)(fuzz::Bytes bytes) {
  const fuzz::ScratchFile file("clip.mp4", bytes);
  fuzz::expect_readable({abrazo::why_no_video(file.path()), "clip.mp4"});
}
