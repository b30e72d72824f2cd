#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace abrazo {

class LibraryFingerprints;
class MotionLibrary;

/// The origin of a recording; kept in the session file.
struct RecordingFacts {
  std::string library_path;  ///< as opened; the file keeps it relative to itself if possible
  std::string library_name;
  std::uint64_t library_pairs = 0;
  std::string input;  ///< URI or clip; an input named by a frame takes precedence
  /// The library itself, or null. If set, the file gets take, frame and label of its pairs, and a changed
  /// library is detected when the file is opened. A library named by a frame takes precedence.
  std::shared_ptr<const MotionLibrary> library;
  std::vector<std::string> excluded_takes;  ///< that the synthesizer leaves out
  /// True if the session's times and indices are those of the file: it was opened from the file or has
  /// recorded into it before. Otherwise they are shifted behind the file's content.
  bool has_times_of_file = false;
  /// Shared by the recordings of a session, so that each library is hashed once; null = not shared.
  std::shared_ptr<LibraryFingerprints> fingerprints = nullptr;
};

/// Limits of the recorder's queue.
struct RecorderOptions {
  double commit_interval_s = 0.1;        ///< latest write to disk after a frame was queued, plus the time of
                                         ///< the write
  std::size_t waiting_frames = 4096;     ///< frames beyond it are lost and counted: 34 s at 120 Hz
  std::size_t waiting_poses = 16384;     ///< of all performers
  std::uint64_t largest_file_bytes = 0;  ///< above it the file counts as full; 0 = limited by the disk only
};

}  // namespace abrazo
