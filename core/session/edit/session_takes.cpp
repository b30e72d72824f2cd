#include "core/session/edit/session_takes.hpp"

#include <algorithm>
#include <utility>

#include "core/session/file/session_contents.hpp"

namespace abrazo {

SessionTakes::SessionTakes(const SessionContents& file) {
  std::vector<std::string> performers;
  for (const SessionPerformer& performer : file.performers) performers.push_back(performer.name);
  for (const SessionTake& take : file.takes) {
    list_.put(
        {take.id, take.name, take.start_s, take.end_s, take.last_frame + 1 - take.first_frame, performers});
    next_id_ = std::max<std::int64_t>(next_id_, take.id + 1);
    names_in_file_[take.id] = take.name;
  }
}

void SessionTakes::begin(const std::string& name, double at_s, std::vector<std::string> performers) {
  running_ = next_id_++;
  list_.put({running_, name, at_s, at_s, 0, std::move(performers)});
  names_in_file_[running_] = name;
}

void SessionTakes::follow(const TakeSpan& recorded) {
  const RecordedTake* running = list_.find(running_);
  if (!running || recorded.frames == 0) return;
  RecordedTake take = *running;
  take.from_s = recorded.first_s;
  take.to_s = recorded.last_s;
  take.frames = recorded.frames;
  list_.put(take);
}

RecordedTake SessionTakes::end() {
  const RecordedTake* running = list_.find(std::exchange(running_, -1));
  const RecordedTake take = running ? *running : RecordedTake{};
  if (take.frames == 0) list_.remove(take.id);
  return take;
}

void SessionTakes::change_in_file(std::int64_t id, const std::optional<std::string>& name) {
  const auto known = names_in_file_.find(id);
  if (known != names_in_file_.end()) edits_[known->second] = name;
}

void SessionTakes::rename(std::int64_t id, const std::string& name) {
  list_.rename(id, name);
  change_in_file(id, name);
}

void SessionTakes::remove(std::int64_t id) {
  list_.remove(id);
  change_in_file(id, std::nullopt);
}

void SessionTakes::restore(const RecordedTake& take) {
  list_.put(take);
  change_in_file(take.id, take.name);
}

TakeEdits SessionTakes::renames() const {
  TakeEdits names;
  for (const auto& [name, now] : edits_)
    if (now) names[name] = now;
  return names;
}

void SessionTakes::written(const TakeEdits& renames) {
  for (const auto& [name, now] : renames) edits_.erase(name);
  for (auto& [id, name] : names_in_file_)
    if (const auto found = renames.find(name); found != renames.end()) name = *found->second;
}

}  // namespace abrazo
