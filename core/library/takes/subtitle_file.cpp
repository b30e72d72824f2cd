#include "core/library/takes/subtitle_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::string_view arrow = "-->";
constexpr const char* unnamed_tier = "subtitles";

struct Cue {
  std::size_t line = 0;
  double start_s = 0, end_s = 0;
  std::string tier = {}, value = {};
};

// ---- times ----

/// "[hh:]mm:ss.mmm", with a comma in .srt; none for other text.
std::optional<double> time_of(std::string_view word) {
  const std::size_t point = word.find_last_of(".,");
  if (point == std::string_view::npos || word.size() - point != 4) return std::nullopt;
  const auto parts = split_fields(word.substr(0, point), ':');
  if (parts.size() < 2 || parts.size() > 3) return std::nullopt;
  long long seconds = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool hours = parts.size() == 3 && i == 0;
    const bool digits =
        std::all_of(parts[i].begin(), parts[i].end(), [](char c) { return c >= '0' && c <= '9'; });
    const auto number = parse_integer(parts[i]);
    if (!number || !digits || parts[i].size() > 5 || (!hours && (parts[i].size() != 2 || *number > 59)))
      return std::nullopt;
    seconds = seconds * 60 + *number;
  }
  const auto thousandths = parse_integer(word.substr(point + 1));
  if (!thousandths || *thousandths < 0 || word[point + 1] < '0') return std::nullopt;
  return static_cast<double>(seconds * 1000 + *thousandths) / 1000;
}

std::string time_text(long long ms, char point) {
  return fmt::format("{:02}:{:02}:{:02}{}{:03}", ms / 3600000, ms / 60000 % 60, ms / 1000 % 60, point,
                     ms % 1000);
}

Result<Cue> timing(std::string_view line_text, std::size_t line, std::string_view where) {
  const std::size_t at = line_text.find(arrow);
  const auto words = split_words(line_text.substr(at + arrow.size()));
  const auto start = time_of(trimmed(line_text.substr(0, at)));
  const auto end = words.empty() ? std::nullopt : time_of(words.front());
  if (!start || !end)
    return error_at_line(
        where, line, fmt::format("expected 00:00:01.000 --> 00:00:02.500, found {}", in_quotes(line_text)));
  if (*end < *start)
    return error_at_line(where, line,
                         fmt::format("the cue ends at {:.3f} s, before its start at {:.3f} s", *end, *start));
  return Cue{line, *start, *end};
}

// ---- text ----

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  std::string replaced;
  std::size_t behind = 0;
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, behind)) {
    replaced.append(text, behind, at - behind).append(to);
    behind = at + from.size();
  }
  text = replaced.append(text, behind);
}

std::string unescaped(std::string text) {
  replace_all(text, "&lt;", "<");
  replace_all(text, "&gt;", ">");
  replace_all(text, "&nbsp;", "\xC2\xA0");
  replace_all(text, "&amp;", "&");
  return text;
}

std::string escaped(std::string text) {
  replace_all(text, "&", "&amp;");
  replace_all(text, "<", "&lt;");
  replace_all(text, ">", "&gt;");
  return text;
}

/// Takes the markup out; the first voice is the tier.
void take_markup(Cue& cue) {
  std::string plain;
  const std::string& text = cue.value;
  const std::size_t last_end = text.rfind('>');  // behind it nothing is looked for
  for (std::size_t at = 0; at < text.size();) {
    const bool is_tag = text[at] == '<' && last_end != std::string::npos && at < last_end;
    const std::size_t end = is_tag ? text.find('>', at) : std::string::npos;
    if (end == std::string::npos) {
      plain += text[at++];
      continue;
    }
    const std::string_view tag(text.data() + at + 1, end - at - 1);
    const bool is_voice = tag.starts_with("v ") || tag.starts_with("v\t") || tag.starts_with("v.");
    if (is_voice && cue.tier.empty()) {
      const std::size_t space = tag.find_first_of(" \t");
      if (space != std::string_view::npos) cue.tier = unescaped(std::string(trimmed(tag.substr(space))));
    }
    at = end + 1;
  }
  cue.value = unescaped(std::move(plain));
}

void take_bracket(Cue& cue) {
  const std::size_t end = cue.value.find(']');
  if (!cue.value.starts_with('[') || end == std::string::npos || end < 2) return;
  cue.tier = trimmed(std::string_view(cue.value).substr(1, end - 1));
  std::size_t from = end + 1;
  if (from < cue.value.size() && cue.value[from] == ' ') ++from;
  cue.value.erase(0, from);
}

// ---- blocks ----

/// The cues of a text whose blocks are parted by empty lines.
Result<std::vector<Cue>> cues_of(std::string_view text, std::string_view where, SubtitleForm form) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  const auto lines = split_lines(text);
  std::size_t at = 0;
  const auto is_blank = [&](std::size_t i) { return i >= lines.size() || trimmed(lines[i]).empty(); };
  if (form == SubtitleForm::WebVtt) {
    if (lines.empty() ||
        !(lines[0] == "WEBVTT" || lines[0].starts_with("WEBVTT ") || lines[0].starts_with("WEBVTT\t")))
      return Error{"does not begin with WEBVTT; is it a .srt file?", std::string(where)};
    while (!is_blank(at)) ++at;
  }
  std::vector<Cue> cues;
  for (; at < lines.size();) {
    if (is_blank(at)) {
      ++at;
      continue;
    }
    std::size_t with_times = at;
    while (!is_blank(with_times) && lines[with_times].find(arrow) == std::string_view::npos) ++with_times;
    if (is_blank(with_times)) {  // a note, a style or a region
      if (form == SubtitleForm::SubRip)
        return error_at_line(where, at + 1,
                             fmt::format("a cue needs a line with times, found {}", in_quotes(lines[at])));
      at = with_times;
      continue;
    }
    auto cue = timing(lines[with_times], with_times + 1, where);
    if (!cue) return cue.error();
    for (at = with_times + 1; !is_blank(at); ++at)
      cue->value += (cue->value.empty() ? "" : "\n") + std::string(lines[at]);
    if (form == SubtitleForm::SubRip) take_bracket(*cue);
    take_markup(*cue);
    cues.push_back(std::move(*cue));
  }
  return cues;
}

constexpr int most_at_a_time = 20;

/// Tiers as cues come in.
struct CueTiers {
  /// The first tier of that name, or that and a number, which is free from the cue's start on; null when too
  /// many cues of it overlap.
  Tier* free_for(const Cue& cue);

  std::vector<Tier> tiers;
  std::map<std::string, std::size_t> places;
  int moved = 0;  ///< cues that went to a further tier
};

Tier* CueTiers::free_for(const Cue& cue) {
  const std::string base = trimmed(cue.tier).empty() ? unnamed_tier : cue.tier;
  for (int copy = 1; copy <= most_at_a_time; ++copy) {
    const std::string name = copy == 1 ? base : fmt::format("{} {}", base, copy);
    const auto [place, is_new] = places.emplace(name, tiers.size());
    if (is_new) tiers.push_back({name, {}, {}, kind_of_name(name)});
    Tier& tier = tiers[place->second];
    if (!is_new && !tier.intervals.empty() && tier.intervals.back().end_s > cue.start_s) continue;
    moved += copy > 1 ? 1 : 0;
    return &tier;
  }
  return nullptr;
}

struct Placed {
  const Tier* tier;
  const TierInterval* interval;
  int number;  ///< in its tier, from 1
};

/// Without the empty lines that would end the cue. @return whether there were any
bool leave_out_empty_lines(std::string& text) {
  std::string full;
  int left_out = 0;
  for (const std::string_view line : split_lines(text)) {
    if (trimmed(line).empty())
      ++left_out;
    else
      full += (full.empty() ? "" : "\n") + std::string(line);
  }
  text = std::move(full);
  return left_out > 0;
}

Status check_name(const Tier& tier, std::string_view where, SubtitleForm form) {
  const std::string_view forbidden = form == SubtitleForm::WebVtt ? "\n\r" : "]\n\r";
  if (tier.name.find_first_of(forbidden) == std::string::npos && tier.name.find(arrow) == std::string::npos)
    return Done{};
  return Error{"subtitles cannot hold the tier name " + in_quotes(tier.name) +
                   "; leave out line ends, arrows and closing brackets",
               std::string(where)};
}

void warn_of_losses(std::span<const Tier> tiers, std::vector<std::string>& warnings) {
  int vocabularies = 0, empty = 0, remarks = 0;
  for (const Tier& tier : tiers) {
    vocabularies += tier.vocabulary.empty() ? 0 : 1;
    empty += tier.intervals.empty() ? 1 : 0;
    for (const TierInterval& one : tier.intervals)
      remarks += one.detail.empty() && one.confidence.empty() ? 0 : 1;
  }
  if (vocabularies > 0)
    warnings.push_back(fmt::format("the vocabulary of {} {} left out; .eaf and .json keep it", vocabularies,
                                   vocabularies == 1 ? "tier was" : "tiers was"));
  if (empty > 0)
    warnings.push_back(fmt::format("{} empty {} left out", empty, empty == 1 ? "tier was" : "tiers were"));
  if (remarks > 0)
    warnings.push_back(fmt::format("detail and confidence of {} {} left out", remarks,
                                   remarks == 1 ? "interval was" : "intervals were"));
}

}  // namespace

Result<TierDocument> parse_subtitles(std::string_view text, std::string_view where, SubtitleForm form) {
  auto cues = cues_of(text, where, form);
  if (!cues) return cues.error();
  std::stable_sort(cues->begin(), cues->end(),
                   [](const Cue& a, const Cue& b) { return a.start_s < b.start_s; });
  TierDocument document;
  CueTiers found;
  int without_length = 0;
  for (Cue& cue : *cues) {
    if (cue.end_s == cue.start_s) {
      ++without_length;
      continue;
    }
    Tier* tier = found.free_for(cue);
    if (!tier)
      return error_at_line(where, cue.line,
                           fmt::format("more than {} cues overlap here; leave some out", most_at_a_time));
    tier->intervals.push_back({cue.start_s, cue.end_s, std::move(cue.value)});
  }
  document.tiers = std::move(found.tiers);
  const int moved = found.moved;
  if (moved > 0)
    document.warnings.push_back(fmt::format("{} {} others of the same tier and went to a further tier", moved,
                                            moved == 1 ? "cue overlaps" : "cues overlap"));
  if (without_length > 0)
    document.warnings.push_back(
        fmt::format("{} without length {} left out",
                    without_length == 1 ? "1 cue" : fmt::format("{} cues", without_length),
                    without_length == 1 ? "was" : "were"));
  return document;
}

Result<TierText> write_subtitles(std::span<const Tier> tiers, std::string_view where, SubtitleForm form) {
  std::vector<Placed> all;
  for (const Tier& tier : tiers) {
    if (const Status named = check_name(tier, where, form); !named) return named.error();
    for (std::size_t i = 0; i < tier.intervals.size(); ++i)
      all.push_back({&tier, &tier.intervals[i], static_cast<int>(i) + 1});
  }
  std::stable_sort(all.begin(), all.end(), [](const Placed& a, const Placed& b) {
    return a.interval->start_s < b.interval->start_s;
  });
  const bool vtt = form == SubtitleForm::WebVtt;
  TierText written{vtt ? "WEBVTT\n" : "", {}};
  int cue = 0, joined = 0;
  for (const Placed& one : all) {
    const long long start = std::llround(one.interval->start_s * 1000);
    const long long end = std::max(std::llround(one.interval->end_s * 1000), start + 1);
    if (start < 0)
      return Error{fmt::format("subtitles have no times before 0; found {:.3f} s", one.interval->start_s),
                   std::string(where)};
    std::string value = one.interval->value;
    if (!value.empty()) joined += leave_out_empty_lines(value) ? 1 : 0;
    const char point = vtt ? '.' : ',';
    if (!written.text.empty()) written.text += '\n';
    written.text += vtt ? fmt::format("{} {}\n", one.tier->name, one.number) : fmt::format("{}\n", ++cue);
    written.text += fmt::format("{} {} {}\n", time_text(start, point), arrow, time_text(end, point));
    written.text += vtt ? fmt::format("<v {}>{}\n", escaped(one.tier->name), escaped(value))
                        : fmt::format("[{}] {}\n", one.tier->name, escaped(value));
  }
  if (joined > 0) written.warnings.push_back(fmt::format("empty lines in {} values were left out", joined));
  warn_of_losses(tiers, written.warnings);
  return written;
}

}  // namespace abrazo
