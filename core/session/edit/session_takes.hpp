#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/session/edit/recorded_takes.hpp"
#include "core/session/file/session_edit.hpp"
#include "core/session/frames/take_span.hpp"

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
  /// @param at_s  session clock; its place until it has a frame
  void begin(const std::string& name, double at_s, std::vector<std::string> performers);
  /// The running take has these frames by now.
  void follow(const TakeSpan& recorded);
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
  TakeEdits edits_;
  std::map<std::int64_t, std::string> names_in_file_;
};

}  // namespace abrazo
