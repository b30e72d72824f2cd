#include "core/session/edit/recorded_takes.hpp"

#include <algorithm>

#include "core/base/text.hpp"

namespace abrazo {

const RecordedTake* RecordedTakes::find(std::int64_t id) const {
  const auto found =
      std::find_if(takes_.begin(), takes_.end(), [id](const auto& take) { return take.id == id; });
  return found == takes_.end() ? nullptr : &*found;
}

std::vector<std::string> RecordedTakes::names() const {
  std::vector<std::string> names;
  for (const RecordedTake& take : takes_) names.push_back(take.name);
  return names;
}

void RecordedTakes::put(const RecordedTake& take) {
  const auto place =
      std::lower_bound(takes_.begin(), takes_.end(), take.id,
                       [](const RecordedTake& other, std::int64_t id) { return other.id < id; });
  if (place != takes_.end() && place->id == take.id)
    *place = take;
  else
    takes_.insert(place, take);
}

std::string RecordedTakes::why_not(std::int64_t id, std::string_view name) const {
  if (trimmed(name).empty()) return "A take needs a name";
  for (const RecordedTake& take : takes_)
    if (take.id != id && take.name == trimmed(name))
      return "'" + take.name + "' is another take of this session; write another name";
  return {};
}

void RecordedTakes::rename(std::int64_t id, std::string_view name) {
  for (RecordedTake& take : takes_)
    if (take.id == id) take.name = trimmed(name);
}

void RecordedTakes::remove(std::int64_t id) {
  std::erase_if(takes_, [id](const RecordedTake& take) { return take.id == id; });
}

}  // namespace abrazo
