#include "core/library/takes/tier_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/atomic_file.hpp"
#include "core/base/text.hpp"
#include "core/base/utf8.hpp"
#include "core/library/takes/eaf_file.hpp"
#include "core/library/takes/elan_text.hpp"
#include "core/library/takes/text_grid.hpp"
#include "core/library/takes/tier_csv.hpp"

namespace abrazo {

namespace {

constexpr std::uintmax_t most_bytes = 64u << 20;
constexpr std::size_t most_intervals = 1'000'000;
constexpr std::string_view text_extension = ".txt", grid_extension = ".textgrid";
constexpr double half_millisecond_s = 0.0005;

std::string extension_of(std::string_view name) {
  const std::size_t point = name.find_last_of('.');
  return point == std::string_view::npos ? std::string() : lower_case(name.substr(point));
}

/// Texts are ELAN's, or Audacity's in microseconds.
bool has_rounded_times(const std::string& extension) {
  return extension == ".eaf" || extension == text_extension || extension == grid_extension;
}

Error unknown_format(const std::string& name) {
  return {fmt::format("is not a label file by its name; use {}", fmt::join(tier_file_extensions(), ", ")),
          name};
}

Status check_text(std::string_view text, const std::string& name, const std::string& extension) {
  if (text.size() > most_bytes)
    return Error{fmt::format("has {} MB; label files have at most {}", text.size() >> 20, most_bytes >> 20),
                 name};
  if (extension == ".eaf" || extension == grid_extension) return Done{};  // state their encoding themselves
  if (const auto byte = first_broken_byte(text))
    return Error{fmt::format("is not UTF-8 text from byte {} on; save it as UTF-8", *byte), name};
  return Done{};
}

Result<TierDocument> parsed(std::string_view text, const std::string& name, const std::string& extension,
                            const TierReading& reading) {
  TierDocument document;
  if (extension == ".csv") return parse_tier_csv(text, name, reading);
  if (extension == grid_extension) return parse_text_grid(text, name);
  if (extension == text_extension && text.find('\t') == std::string_view::npos)
    return parse_tier_csv(text, name, reading);
  if (extension == text_extension) return parse_elan_table(text, name);
  if (extension == ".json") {
    auto tiers = parse_tiers_json(text, name, document.warnings);
    if (!tiers) return tiers.error();
    document.tiers = std::move(*tiers);
    return document;
  }
  const auto contents = parse_eaf(text, name);
  if (!contents) return contents.error();
  auto tiers = tiers_of(*contents, name, document.warnings);
  if (!tiers) return tiers.error();
  document.tiers = std::move(*tiers);
  return document;
}

/// The frame that a time in whole milliseconds means; the time itself when it means none.
double on_frame(double time_s, double fps) {
  const double frame_s = std::round(time_s * fps) / fps;
  return std::abs(frame_s - time_s) <= half_millisecond_s + 1e-9 ? frame_s : time_s;
}

void put_on_frames(std::vector<Tier>& tiers, double fps) {
  for (Tier& tier : tiers)
    for (TierInterval& one : tier.intervals) {
      const double start_s = on_frame(one.start_s, fps), end_s = on_frame(one.end_s, fps);
      if (end_s > start_s) one.start_s = start_s, one.end_s = end_s;
    }
}

void warn_of_rounding(std::span<const Tier> tiers, std::vector<std::string>& warnings) {
  std::size_t all = 0, rounded = 0;
  const auto count = [&](double time_s) {
    ++all;
    rounded += std::abs(time_s * 1000 - std::round(time_s * 1000)) > 1e-6 ? 1 : 0;
  };
  for (const Tier& tier : tiers)
    for (const TierInterval& one : tier.intervals) count(one.start_s), count(one.end_s);
  if (rounded > 0)
    warnings.push_back(fmt::format("{} of {} times were rounded to whole milliseconds", rounded, all));
}

std::size_t intervals_in(std::span<const Tier> tiers) {
  std::size_t count = 0;
  for (const Tier& tier : tiers) count += tier.intervals.size();
  return count;
}

/// Without intervals that have no length, which nothing can show. @return how many there were
int leave_out_empty(std::vector<Tier>& tiers) {
  std::size_t left_out = 0;
  for (Tier& tier : tiers)
    left_out +=
        std::erase_if(tier.intervals, [](const TierInterval& one) { return one.end_s == one.start_s; });
  return static_cast<int>(left_out);
}

Result<TierText> written(std::span<const Tier> tiers, const std::string& name, const std::string& extension,
                         const TierWriting& writing) {
  if (extension == ".csv") return writing.take.empty() ? tier_csv(tiers) : label_csv(tiers, name, writing);
  if (extension == ".json") return TierText{tiers_json(tiers), {}};
  if (extension == grid_extension) return text_grid(tiers);
  if (extension == text_extension) return audacity_labels(tiers, name);
  auto eaf = write_eaf(tiers, {writing.author, writing.date});
  if (!eaf) return Error{eaf.error().text(), name};
  TierText text{std::move(*eaf), {}};
  warn_of_rounding(tiers, text.warnings);
  return text;
}

}  // namespace

const std::vector<std::string>& tier_file_extensions() {
  static const std::vector<std::string> extensions = {".eaf", ".csv", ".json", ".TextGrid", ".txt"};
  return extensions;
}

bool is_tier_file(std::string_view name) {
  return std::ranges::any_of(
      tier_file_extensions(),
      [extension = extension_of(name)](const std::string& known) { return lower_case(known) == extension; });
}

Result<TierDocument> parse_tiers(std::string_view text, const std::string& name, const TierReading& reading) {
  if (!is_tier_file(name)) return unknown_format(name);
  const std::string extension = extension_of(name);
  if (const Status checked = check_text(text, name, extension); !checked) return checked.error();
  auto document = parsed(text, name, extension, reading);
  if (!document) return document.error();
  if (intervals_in(document->tiers) > most_intervals)
    return Error{fmt::format("has {} intervals; a label file has at most {}", intervals_in(document->tiers),
                             most_intervals),
                 name};
  if (reading.fps > 0 && has_rounded_times(extension)) put_on_frames(document->tiers, reading.fps);
  if (const Status checked = check_tiers(document->tiers, name); !checked) return checked.error();
  return document;
}

Result<TierDocument> read_tiers(const std::filesystem::path& file, const TierReading& reading) {
  if (!is_tier_file(file.string())) return unknown_format(file.string());
  std::error_code failure;
  const auto bytes = std::filesystem::file_size(file, failure);
  if (!failure && bytes > most_bytes)
    return Error{fmt::format("has {} MB; label files have at most {}", bytes >> 20, most_bytes >> 20),
                 file.string()};
  const auto text = read_whole_file(file);
  if (!text) return text.error();
  return parse_tiers(*text, file.string(), reading);
}

Result<TierText> write_tiers(std::span<const Tier> tiers, const std::string& name,
                             const TierWriting& writing) {
  if (!is_tier_file(name)) return unknown_format(name);
  std::vector<Tier> kept(tiers.begin(), tiers.end());
  const int left_out = leave_out_empty(kept);
  if (const Status checked = check_tiers(kept, name); !checked) return checked.error();
  auto text = written(kept, name, extension_of(name), writing);
  if (text && left_out > 0)
    text->warnings.push_back(fmt::format("{} without length {} left out",
                                         left_out == 1 ? "1 interval" : fmt::format("{} intervals", left_out),
                                         left_out == 1 ? "was" : "were"));
  return text;
}

}  // namespace abrazo
