#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/session/edit/take_sequence.hpp"

namespace abrazo::widgets {

/// What the recording of a session looks like at this moment.
struct RecordingStatus {
  TakeSequence::Phase phase = TakeSequence::Phase::Idle;
  std::string take;  ///< that is recorded, or will be after the countdown
  int count = 0;     ///< of the countdown
  double elapsed_s = 0;
  std::string file;                 ///< empty while nothing is kept on disk
  std::uint64_t bytes = 0;          ///< on disk
  std::uint64_t frames = 0;         ///< on disk
  double behind_s = 0;              ///< age of the oldest frame that is not on disk yet
  std::string failure;              ///< why nothing more is written
  std::uint64_t lost = 0;           ///< frames since then
  bool is_everything_kept = false;  ///< from the first frame on, and not only while a take is recorded
  bool can_record = false;          ///< there is a session

  bool operator==(const RecordingStatus&) const = default;
};

/// What the state of the disk is, in one line; and whether it is something to worry about.
struct DiskWords {
  enum class Weight { Fine, Behind, Failed };
  std::string text;
  Weight weight = Weight::Fine;
};
DiskWords disk_words(const RecordingStatus& status);

/// "00:35", "1:02:03".
std::string duration_text(double seconds);
/// "812 kB", "12.4 MB", "1.24 GB": powers of ten, as file managers have them.
std::string disk_size_text(std::uint64_t bytes);

}  // namespace abrazo::widgets
