#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace abrazo {

class LibraryFingerprints;
class MotionLibrary;

/// What a recording says of where it came from; kept in the session file.
struct RecordingFacts {
  std::string library_path;  ///< as it was opened; the file keeps it relative to itself where it can
  std::string library_name;
  std::uint64_t library_pairs = 0;
  std::string input;  ///< URI or clip; frames that name an input of their own go before it
  /// The library itself when it is at hand: its pairs get their take, frame and label in the file, and a
  /// changed one is noticed when the file is opened. Frames that name a library of their own go before it.
  std::shared_ptr<const MotionLibrary> library;
  std::vector<std::string> excluded_takes;  ///< that the synthesizer was told to leave out
  /// The session's times and indices are those of the file, in which it goes on: it was opened from there, or
  /// has recorded into it before. Otherwise they are put behind what the file has.
  bool has_times_of_file = false;
  /// Shared by the recordings of a session, so that none goes through a library that another knows; null =
  /// one of its own.
  std::shared_ptr<LibraryFingerprints> fingerprints = nullptr;
};

/// How much waits in memory and for how long.
struct RecorderOptions {
  double commit_interval_s = 0.1;        ///< what was handed over is on disk so much later, and a write
  std::size_t waiting_frames = 4096;     ///< more than that are lost and counted: 34 s at 120 Hz
  std::size_t waiting_poses = 16384;     ///< of all performers
  std::uint64_t largest_file_bytes = 0;  ///< then it counts as full; 0 = as large as the disk is
};

}  // namespace abrazo
