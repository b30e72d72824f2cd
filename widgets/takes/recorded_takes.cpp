#include "widgets/takes/recorded_takes.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "core/base/text.hpp"

namespace abrazo::widgets {

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

std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(std::max(0.0, seconds));
  std::array<char, 40> text{};
  if (whole < 3600)
    std::snprintf(text.data(), text.size(), "%02lld:%02lld", whole / 60, whole % 60);
  else
    std::snprintf(text.data(), text.size(), "%lld:%02lld:%02lld", whole / 3600, whole / 60 % 60, whole % 60);
  return text.data();
}

std::string disk_size_text(std::uint64_t bytes) {
  static constexpr std::array<const char*, 5> units = {"B", "kB", "MB", "GB", "TB"};
  auto amount = static_cast<double>(bytes);
  std::size_t unit = 0;
  // 999.5 kB would be written "1000 kB".
  for (; amount >= 999.5 && unit + 1 < units.size(); ++unit) amount /= 1000;
  const int decimals = unit < 2 || amount >= 99.95 ? 0 : amount >= 9.995 ? 1 : 2;
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.*f %s", decimals, amount, units[unit]);
  return text.data();
}

}  // namespace abrazo::widgets
