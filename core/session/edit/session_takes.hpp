#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/edit/recorded_takes.hpp"
#include "core/session/file/session_edit.hpp"

namespace abrazo {

struct SessionContents;

/// The takes of a running session: the listed ones, the one being recorded, and the changes not yet in its
/// file. Plain data and rules; the owner writes the file.
class SessionTakes {
 public:
  SessionTakes() = default;
  /// For a session that was opened from its file.
  explicit SessionTakes(const SessionContents& file);

  const RecordedTakes& list() const { return list_; }
  /// Id of the take being recorded; -1 = none.
  std::int64_t running() const { return running_; }

  /// Begins a take; the file gets this name.
  /// @param from_s  session clock
  /// @param first_frame index of its first frame
  void begin(const std::string& name, double from_s, std::uint64_t first_frame,
             std::vector<std::string> performers);
  /// Extends the running take to the newest frame of the session, wherever the cursor is.
  void follow(double newest_s, std::uint64_t newest_frame);
  /// Ends the running take. A take without frames is removed.
  /// @return the take; its `frames` are 0 if it was not kept
  RecordedTake end();

  /// No effect on an unknown id.
  void rename(std::int64_t id, const std::string& name);
  void remove(std::int64_t id);
  /// Undoes `remove`.
  void restore(const RecordedTake& take);

  /// Changes not yet in the file, by the names that the takes have there.
  const TakeEdits& edits() const { return edits_; }
  /// Only the renames among `edits`: a removed take can be restored until the session ends.
  TakeEdits renames() const;
  /// Reports that these renames are in the file.
  void written(const TakeEdits& renames);

 private:
  void change_in_file(std::int64_t id, const std::optional<std::string>& name);

  RecordedTakes list_;
  std::int64_t running_ = -1, next_id_ = 1;
  std::uint64_t first_frame_ = 0;  ///< of the running take
  TakeEdits edits_;
  std::map<std::int64_t, std::string> names_in_file_;
};

}  // namespace abrazo
