#include "core/library/takes/elan_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/text.hpp"
#include "core/library/takes/csv_text.hpp"
#include "core/motion/tables/table_line.hpp"

namespace abrazo {

namespace {

constexpr const char* elan_form =
    "expected ELAN's table of annotations: tier, participant, begin time, end time, duration and annotation, "
    "with tabs or commas between them";
constexpr const char* with_titles = "; export with the option \"Include column titles\"";
constexpr const char* nameless_tier = "annotations";
constexpr double rounding_s = 0.0015;  ///< of two times in whole milliseconds

// ---- times ----

enum class TimeForm { Clock, Seconds, Thousandths, Smpte };

/// "00:01:02.340", "62.34", "62340" or "00:01:02:08".
std::optional<TimeForm> form_of(std::string_view cell) {
  const auto colons = std::ranges::count(cell, ':');
  if (colons == 0 && table_number(cell))
    return cell.find_first_of(".,") == std::string_view::npos ? TimeForm::Thousandths : TimeForm::Seconds;
  if (colons != 2 && colons != 3) return std::nullopt;
  for (const std::string_view part : split_fields(cell, ':'))
    if (!table_number(part)) return std::nullopt;
  return colons == 2 ? TimeForm::Clock : TimeForm::Smpte;
}

/// A column of times.
struct TimeColumn {
  std::size_t at = 0;
  TimeForm form = TimeForm::Seconds;
  double fps = 0;  ///< of SMPTE frames; 0 = not known
};

std::optional<double> seconds_of(std::string_view cell, const TimeColumn& column) {
  const auto form = form_of(cell);
  if (!form || (*form == TimeForm::Clock) != (column.form == TimeForm::Clock) ||
      (*form == TimeForm::Smpte) != (column.form == TimeForm::Smpte))
    return std::nullopt;
  auto parts = split_fields(cell, ':');
  double frames_s = 0;
  if (*form == TimeForm::Smpte) {
    frames_s = column.fps > 0 ? *table_number(parts.back()) / column.fps : 0;
    parts.pop_back();
  }
  double seconds = 0;
  for (const std::string_view part : parts) {
    const double number = *table_number(part);
    if (!(number >= 0) || !std::isfinite(number)) return std::nullopt;
    seconds = 60 * seconds + number;
  }
  return column.form == TimeForm::Thousandths ? seconds / 1000 : seconds + frames_s;
}

// ---- columns ----

using Rows = std::vector<CsvRow>;

std::string_view cell_at(const CsvRow& row, std::size_t at) {
  return at < row.fields.size() ? std::string_view(row.fields[at]) : std::string_view();
}

/// A column whose cells are the values of a tier.
struct ValueColumn {
  std::size_t at = 0;
  std::string tier;  ///< if the table has no column with names of tiers
};

struct ElanColumns {
  std::optional<std::size_t> tier;
  TimeColumn begin;
  std::optional<TimeColumn> end, duration;  ///< one of them
  std::vector<ValueColumn> values;
  std::vector<std::string> warnings;
};

// ---- columns by title ----

TimeColumn titled_time(std::string_view title, std::size_t at) {
  const auto says = [title](std::string_view word) { return title.find(word) != std::string_view::npos; };
  if (says("ss:ff")) return {at, TimeForm::Smpte, says("pal") ? (says("50") ? 50.0 : 25.0) : 0.0};
  if (says("hh:mm:ss")) return {at, TimeForm::Clock};
  return {at, says("ss.msec") ? TimeForm::Seconds : TimeForm::Thousandths};
}

/// Of several forms one that is exact to the millisecond.
void take_better(std::optional<TimeColumn>& known, const TimeColumn& other) {
  if (!known || (known->form == TimeForm::Smpte && other.form != TimeForm::Smpte)) known = other;
}

bool is_title_of_times(std::string_view title) {
  return title.starts_with("begin time") || title.starts_with("end time");
}

bool has_titles(const CsvRow& row) {
  return std::ranges::any_of(row.fields,
                             [](const std::string& title) { return is_title_of_times(lower_case(title)); });
}

Result<ElanColumns> titled_columns(const CsvRow& titles, std::string_view where) {
  ElanColumns columns;
  std::optional<TimeColumn> begin;
  std::optional<std::size_t> annotation;
  std::vector<ValueColumn> others;
  for (std::size_t at = 0; at < titles.fields.size(); ++at) {
    const std::string title = lower_case(titles.fields[at]);
    if (title == "tier")
      columns.tier = at;
    else if (title == "annotation")
      annotation = at;
    else if (title.starts_with("begin time"))
      take_better(begin, titled_time(title, at));
    else if (title.starts_with("end time"))
      take_better(columns.end, titled_time(title, at));
    else if (title.starts_with("duration"))
      take_better(columns.duration, titled_time(title, at));
    else if (!title.empty() && title != "participant" && title != "annotator" && !title.starts_with("file") &&
             !title.starts_with("cv"))
      others.push_back({at, titles.fields[at]});
  }
  if (annotation) {
    columns.values = {{*annotation, nameless_tier}};
    for (const ValueColumn& other : others)
      columns.warnings.push_back(fmt::format("the column {} is not read", in_quotes(other.tier)));
  } else if (!columns.tier) {
    columns.values = std::move(others);
  }
  if (!begin || (!columns.end && !columns.duration) || columns.values.empty())
    return error_at_line(where, titles.line,
                         "lacks a column of begin, of end or duration, or of annotations");
  columns.begin = *begin;
  for (const auto& time : {begin, columns.end ? columns.end : columns.duration})
    if (time->form == TimeForm::Smpte && time->fps == 0)
      return error_at_line(
          where, titles.line,
          "has times in SMPTE frames of an unknown rate; export seconds or milliseconds too");
  return columns;
}

// ---- columns by what they hold ----

/// Forms of the columns whose cells are all times, in the first `count` rows; none for others.
std::vector<std::optional<TimeForm>> forms_of(const Rows& rows, std::size_t count) {
  std::vector<std::optional<TimeForm>> forms;
  for (const std::string& cell : rows.front().fields) forms.push_back(form_of(cell));
  for (std::size_t r = 1; r < count; ++r)
    for (std::size_t at = 0; at < forms.size(); ++at) {
      if (!forms[at]) continue;
      const auto other = form_of(cell_at(rows[r], at));
      const bool has_a_point = other == TimeForm::Seconds && forms[at] == TimeForm::Thousandths;
      const bool lacks_it = other == TimeForm::Thousandths && forms[at] == TimeForm::Seconds;
      if (has_a_point)
        forms[at] = TimeForm::Seconds;
      else if (other != forms[at] && !lacks_it)
        forms[at] = std::nullopt;
    }
  return forms;
}

/// A block of times: begin, end and duration, or two of them, each in `forms.size() / kinds` forms.
struct TimeBlock {
  std::size_t first = 0, width = 0;
  std::size_t kinds = 3;
  bool has_end = true;  ///< of two kinds: the second is the end
};

std::optional<TimeColumn> exact_of(const TimeBlock& block, std::size_t kind,
                                   const std::vector<std::optional<TimeForm>>& forms) {
  const std::size_t each = block.width / block.kinds;
  std::optional<TimeColumn> best;
  for (std::size_t i = 0; i < each; ++i) {
    const std::size_t at = block.first + kind * each + i;
    take_better(best, {at, *forms[at]});
  }
  return best;
}

/// Whether the columns of a block are its times in each of the first `count` rows.
bool agrees(const TimeBlock& block, const Rows& rows, std::size_t count,
            const std::vector<std::optional<TimeForm>>& forms) {
  const std::size_t each = block.width / block.kinds;
  for (std::size_t i = 0; i < block.width; ++i)
    if (forms[block.first + i] != forms[block.first + i % each]) return false;  // the same forms for each
  for (std::size_t i = 1; i < each; ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (forms[block.first + i] == forms[block.first + j]) return false;
  for (std::size_t r = 0; r < count; ++r) {
    std::vector<double> times_s;
    for (std::size_t kind = 0; kind < block.kinds; ++kind) {
      const auto exact = exact_of(block, kind, forms);
      const auto time_s = seconds_of(cell_at(rows[r], exact->at), *exact);
      if (!time_s) return false;
      times_s.push_back(*time_s);
      for (std::size_t i = 0; i < each; ++i) {
        const TimeColumn same{block.first + kind * each + i, *forms[block.first + kind * each + i]};
        const auto again_s = seconds_of(cell_at(rows[r], same.at), same);
        const double apart_s = same.form == TimeForm::Smpte ? 1 : rounding_s;
        if (!again_s || std::abs(*again_s - *time_s) > apart_s) return false;
      }
    }
    if (block.has_end && times_s[1] < times_s[0]) return false;
    if (block.kinds == 3 && std::abs(times_s[1] - times_s[0] - times_s[2]) > rounding_s) return false;
  }
  return true;
}

/// The longest block of times in the first `count` rows; of equally long ones that of most kinds.
std::optional<TimeBlock> time_block(const Rows& rows, std::size_t count) {
  const auto forms = forms_of(rows, count);
  for (std::size_t width = std::min<std::size_t>(forms.size(), 12); width >= 2; --width)
    for (const auto& [kinds, has_end] : {std::pair(3u, true), std::pair(2u, true), std::pair(2u, false)})
      for (std::size_t first = 0; width % kinds == 0 && first + width <= forms.size(); ++first) {
        const TimeBlock block{first, width, kinds, has_end};
        const auto begin = forms.begin() + static_cast<std::ptrdiff_t>(first);
        if (std::all_of(begin, begin + static_cast<std::ptrdiff_t>(width),
                        [](const auto& form) { return form.has_value(); }) &&
            agrees(block, rows, count, forms))
          return block;
      }
  return std::nullopt;
}

/// Where a column beside the block has times in at least half of the rows but not in all, and so was not
/// understood: the first row without.
std::optional<std::size_t> row_without_time(const Rows& rows, const TimeBlock& block) {
  const auto is_time = [&](std::size_t row, std::size_t at) {
    const auto form = form_of(cell_at(rows[row], at));
    return form == TimeForm::Clock || form == TimeForm::Seconds;
  };
  for (const std::size_t at : {block.first - 1, block.first + block.width}) {  // the first may be none
    std::size_t times = 0;
    std::optional<std::size_t> other;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (is_time(r, at))
        ++times;
      else if (!other)
        other = r;
    }
    if (other && 2 * times >= rows.size()) return other;
  }
  return std::nullopt;
}

/// The first row from which on no block of times fits all rows so far.
std::size_t first_unlike(const Rows& rows) {
  std::size_t fits = 0, fails = rows.size();
  while (fits + 1 < fails) {
    const std::size_t middle = (fits + fails) / 2;
    (time_block(rows, middle) ? fits : fails) = middle;
  }
  return fails - 1;
}

std::string text_of(const CsvRow& row) {
  std::string text;
  for (const std::string& cell : row.fields) text += (text.empty() ? "" : " | ") + cell;
  return text;
}

/// Whether the column names the file that each annotation is from.
bool names_files(const Rows& rows, std::size_t at) {
  return std::ranges::all_of(rows, [at](const CsvRow& row) {
    const std::string cell = lower_case(cell_at(row, at));
    return cell.ends_with(".eaf") || cell.starts_with("file:");
  });
}

Result<ElanColumns> columns_by_content(const Rows& rows, std::string_view where) {
  const auto block = time_block(rows, rows.size());
  const auto without = block ? row_without_time(rows, *block) : first_unlike(rows);
  if (without) {
    const CsvRow& row = rows[*without];
    return error_at_line(where, row.line, std::string(elan_form) + ", found " + in_quotes(text_of(row)));
  }
  const auto forms = forms_of(rows, rows.size());
  ElanColumns columns;
  columns.begin = *exact_of(*block, 0, forms);
  (block->has_end ? columns.end : columns.duration) = exact_of(*block, 1, forms);
  if (columns.begin.form == TimeForm::Smpte)
    return error_at_line(where, rows.front().line,
                         "has times in SMPTE frames of an unknown rate; export seconds or milliseconds too");
  if (block->first > 0) columns.tier = 0;
  if (block->kinds == 2 && columns.tier)  // a label track of Audacity has no tiers
    columns.warnings.push_back(
        fmt::format("has two times for each annotation and no titles: they were taken as begin and {}",
                    block->has_end ? "end" : "duration"));
  std::vector<std::size_t> behind;
  const auto are_times = [&](std::size_t at) {  // a duration that is not that between begin and end
    return at + 1 < forms.size() && (forms[at] == TimeForm::Clock || forms[at] == TimeForm::Seconds);
  };
  std::size_t first_text = block->first + block->width;
  while (are_times(first_text)) ++first_text;
  for (std::size_t at = first_text; at < rows.front().fields.size(); ++at)
    if (!names_files(rows, at)) behind.push_back(at);
  const std::size_t most = columns.tier ? 2 : 1;  // the annotation, and the description of its value
  if (behind.empty() || behind.size() > most)
    return error_at_line(where, rows.front().line,
                         fmt::format("has {} columns behind the times, and nothing says what they are{}",
                                     behind.size(), with_titles));
  columns.values = {{behind.front(), nameless_tier}};
  return columns;
}

// ---- rows ----

Result<Rows> rows_of(std::string_view text, std::string_view where) {
  if (text.find('\t') == std::string_view::npos) return parse_csv(text, where);
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Rows rows;
  std::size_t line = 0;
  for (const std::string_view each : split_lines(text)) {
    ++line;
    if (trimmed(each).empty()) continue;
    CsvRow row{line, {}};
    for (const std::string_view cell : split_fields(each, '\t')) row.fields.emplace_back(cell);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// ELAN can write above everything where the media are.
void leave_out_media(Rows& rows) {
  const auto is_of_media = [](const CsvRow& row) {
    return row.fields.size() == 1 && (row.fields[0].starts_with('#') || row.fields[0].starts_with("\"#"));
  };
  rows.erase(rows.begin(), std::ranges::find_if_not(rows, is_of_media));
}

/// Audacity writes the frequencies of a selection as a line of its own.
void leave_out_frequencies(Rows& rows) {
  std::erase_if(rows, [](const CsvRow& row) { return row.fields[0] == "\\"; });
}

struct Times {
  double begin_s = 0, end_s = 0;
};

Result<Times> times_of(const CsvRow& row, const ElanColumns& columns, std::string_view where) {
  const TimeColumn& last = columns.end ? *columns.end : *columns.duration;
  const auto begin_s = seconds_of(cell_at(row, columns.begin.at), columns.begin);
  const auto last_s = seconds_of(cell_at(row, last.at), last);
  if (!begin_s || !last_s)
    return error_at_line(where, row.line,
                         "expected the times of an annotation, found " +
                             in_quotes(cell_at(row, columns.begin.at)) + " and " +
                             in_quotes(cell_at(row, last.at)));
  const Times times{*begin_s, columns.end ? *last_s : *begin_s + *last_s};
  if (times.end_s < times.begin_s)
    return error_at_line(
        where, row.line,
        fmt::format("the annotation ends at {:.3f} s, and begins at {:.3f} s", times.end_s, times.begin_s));
  return times;
}

Result<TierDocument> document_of(const Rows& rows, std::size_t first, ElanColumns columns,
                                 std::string_view where) {
  TiersInOrder tiers;
  std::size_t without_length = 0;
  for (std::size_t r = first; r < rows.size(); ++r) {
    const auto times = times_of(rows[r], columns, where);
    if (!times) return times.error();
    for (const ValueColumn& column : columns.values) {
      const std::string value(cell_at(rows[r], column.at));
      if (value.empty() && columns.values.size() > 1) continue;
      std::string name = columns.tier ? std::string(cell_at(rows[r], *columns.tier)) : column.tier;
      if (times->end_s == times->begin_s)
        ++without_length;
      else
        tiers.named(name.empty() ? nameless_tier : name)
            .intervals.push_back({times->begin_s, times->end_s, value});
    }
  }
  if (without_length > 0)
    columns.warnings.push_back(fmt::format("{} annotation{} without length {} left out", without_length,
                                           without_length == 1 ? "" : "s",
                                           without_length == 1 ? "was" : "were"));
  return TierDocument{tiers.taken(), {}, std::move(columns.warnings)};
}

}  // namespace

bool is_elan_table(std::string_view text) {
  auto rows = rows_of(text, "");
  if (!rows) return false;
  leave_out_media(*rows);
  if (rows->empty()) return false;
  if (has_titles(rows->front())) return true;
  const auto block = time_block(*rows, rows->size());
  return block && (block->kinds == 3 || forms_of(*rows, 1)[block->first] == TimeForm::Clock);
}

Result<TierDocument> parse_elan_table(std::string_view text, std::string_view where) {
  auto rows = rows_of(text, where);
  if (!rows) return rows.error();
  leave_out_media(*rows);
  leave_out_frequencies(*rows);
  if (rows->empty()) return Error{std::string("has no annotations; ") + elan_form, std::string(where)};
  const bool is_titled = has_titles(rows->front());
  auto columns = is_titled ? titled_columns(rows->front(), where) : columns_by_content(*rows, where);
  if (!columns) return columns.error();
  return document_of(*rows, is_titled ? 1 : 0, std::move(*columns), where);
}

}  // namespace abrazo
