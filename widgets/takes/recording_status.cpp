#include "widgets/takes/recording_status.hpp"

#include <array>
#include <cstdio>

#include "widgets/takes/recorded_takes.hpp"

namespace abrazo::widgets {

DiskWords disk_words(const RecordingStatus& status) {
  using Weight = DiskWords::Weight;
  constexpr double noticed_s = 1;  // the recorder promises half a second
  if (!status.failure.empty()) {
    std::string text = status.failure;
    if (status.lost > 0)
      text += "; " + std::to_string(status.lost) + (status.lost == 1 ? " frame" : " frames") + " lost since";
    return {text, Weight::Failed};
  }
  if (status.file.empty()) return {"Nothing is written to disk yet", Weight::Fine};
  const std::string size = disk_size_text(status.bytes) + " on disk";
  if (status.behind_s < noticed_s) return {size, Weight::Fine};
  std::array<char, 40> behind{};
  std::snprintf(behind.data(), behind.size(), "%.1f s behind", status.behind_s);
  return {size + ", " + behind.data() + ": the disk is slow", Weight::Behind};
}

}  // namespace abrazo::widgets
