#include "widgets/takes/recording_status.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace abrazo::widgets {

DiskWords disk_words(const RecordingStatus& status) {
  using Weight = DiskWords::Weight;
  constexpr double noticed_s = 1;  // the recorder promises half a second
  if (!status.failure.empty()) {
    std::string text = status.failure;
    if (status.lost > 0)
      text += "; " + std::to_string(status.lost) + (status.lost == 1 ? " frame" : " frames") + " lost since";
    return {text, Weight::Failed};
  }
  if (status.file.empty()) return {"Nothing is written to disk yet", Weight::Fine};
  const std::string size = disk_size_text(status.bytes) + " on disk";
  if (status.behind_s < noticed_s) return {size, Weight::Fine};
  std::array<char, 40> behind{};
  std::snprintf(behind.data(), behind.size(), "%.1f s behind", status.behind_s);
  return {size + ", " + behind.data() + ": the disk is slow", Weight::Behind};
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
