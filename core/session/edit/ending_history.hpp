#pragma once

namespace abrazo {

/// The history of a session that is about to end, as far as it is in no session file.
struct EndingHistory {
  double unsaved_s = 0;    ///< its length [s]
  double performed_s = 0;  ///< of it, with a live performer [s]
  /// Only a generated set ran, with its own leader: no file was opened, and no stream was connected.
  bool is_demo = false;
  /// A person did something that the session would lose: unsaved changes, takes, in or out.
  bool is_touched = false;
};

/// A session goes on for a moment while it is opened, saved and closed [s].
inline constexpr double history_settles_s = 10;

/// What a live performer did cannot be had again: this much is worth a question [s].
inline constexpr double performance_counts_s = 1;

/// Whether a person has to say what becomes of it. Only a demo that nobody touched, and what is shorter than
/// `settles_s` and has less than a second of a live performer, is deleted without a question.
inline bool asks_before_deleting(const EndingHistory& history, double settles_s = history_settles_s) {
  if (history.performed_s >= performance_counts_s) return true;
  return history.unsaved_s >= settles_s && (!history.is_demo || history.is_touched);
}

}  // namespace abrazo
