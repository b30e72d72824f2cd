#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/session/edit/take_sequence.hpp"

namespace abrazo::widgets {

/// The present state of recording a session.
struct RecordingStatus {
  TakeSequence::Phase phase = TakeSequence::Phase::Idle;
  std::string take;  ///< being recorded, or after the countdown
  int count = 0;     ///< of the countdown
  double elapsed_s = 0;
  std::string file;                 ///< empty while not recording to disk
  std::string folder;               ///< where a recording will be
  std::uint64_t bytes = 0;          ///< on disk
  std::uint64_t frames = 0;         ///< on disk
  double behind_s = 0;              ///< age of the oldest frame that is not on disk yet
  std::string failure;              ///< why writing stopped
  std::uint64_t lost = 0;           ///< frames lost since then
  bool is_everything_kept = false;  ///< records from the first frame, not only during takes
  bool can_record = false;          ///< a session is running

  bool operator==(const RecordingStatus&) const = default;
};

/// State of the disk in one line, and whether it is a problem.
struct DiskWords {
  enum class Weight { Fine, Behind, Failed };
  std::string text;
  Weight weight = Weight::Fine;
};
DiskWords disk_words(const RecordingStatus& status);

/// "00:35", "1:02:03".
std::string duration_text(double seconds);
/// "812 kB", "12.4 MB", "1.24 GB": powers of ten, as in file managers.
std::string disk_size_text(std::uint64_t bytes);

}  // namespace abrazo::widgets
