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

/// The takes of a session while it runs: those on its list, the one that is being recorded, and the changes
/// that its file does not have yet. Plain data and rules; who owns it writes the file.
class SessionTakes {
 public:
  SessionTakes() = default;
  /// Of a session that was opened from its file.
  explicit SessionTakes(const SessionContents& file);

  const RecordedTakes& list() const { return list_; }
  /// Id of the take that is being recorded; -1 = none.
  std::int64_t running() const { return running_; }

  /// A take begins; its name is the one the file gets.
  /// @param from_s  session clock
  /// @param first_frame  index of the first frame that will belong to it
  void begin(const std::string& name, double from_s, std::uint64_t first_frame,
             std::vector<std::string> performers);
  /// The running take lasts until the newest frame of the session, whatever is looked at meanwhile.
  void follow(double newest_s, std::uint64_t newest_frame);
  /// The running take is over. Without a frame it leaves the list.
  /// @return it, as it was; its `frames` are 0 when it was not kept
  RecordedTake end();

  /// Without effect on an id that is not there.
  void rename(std::int64_t id, const std::string& name);
  void remove(std::int64_t id);
  /// Undoes `remove`.
  void restore(const RecordedTake& take);

  /// What is still to be changed in the file, by the names that the takes have there.
  const TakeEdits& edits() const { return edits_; }
  /// Of those the new names alone: what was removed can be restored until the session ends.
  TakeEdits renames() const;
  /// These are in the file now.
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
