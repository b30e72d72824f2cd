#include "core/library/takes/tier_csv.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.hpp"
#include "core/library/takes/csv_text.hpp"
#include "core/library/takes/elan_text.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/library/takes/take_labels.hpp"

namespace abrazo {

namespace {

enum Column { TierName, Start, End, Value, Detail, Confidence, column_count };

/// Column indices of the exchange form; -1 = missing.
using Columns = std::array<int, column_count>;

int column_of(const std::string& title) {
  const std::string lower = lower_case(title);
  const auto is = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), lower) != names.end();
  };
  if (is({"tier"})) return TierName;
  if (is({"start", "start_s"})) return Start;
  if (is({"end", "end_s"})) return End;
  if (is({"value", "label"})) return Value;
  if (is({"detail"})) return Detail;
  if (is({"confidence"})) return Confidence;
  return -1;
}

Result<Columns> columns_of(const CsvRow& header, std::string_view where, std::vector<std::string>& warnings) {
  Columns columns;
  columns.fill(-1);
  for (std::size_t i = 0; i < header.fields.size(); ++i) {
    const int column = column_of(header.fields[i]);
    if (column < 0)
      warnings.push_back(fmt::format("the column {} is not read", in_quotes(header.fields[i])));
    else
      columns[static_cast<std::size_t>(column)] = static_cast<int>(i);
  }
  for (const Column needed : {Start, End, Value})
    if (columns[needed] < 0)
      return error_at_line(
          where, header.line,
          "expected the columns tier,start,end,value[,detail,confidence]; one of them is missing");
  return columns;
}

Result<double> seconds(const std::string& field, const char* what, std::string_view where, std::size_t line) {
  const auto number = parse_number(field);
  if (!number || !std::isfinite(*number))
    return error_at_line(where, line,
                         fmt::format("expected {} in seconds, found {}", what, in_quotes(field)));
  return *number;
}

Result<TierDocument> parse_exchange(const std::vector<CsvRow>& rows, std::string_view where) {
  TierDocument document;
  TiersInOrder tiers;
  const auto columns = columns_of(rows.front(), where, document.warnings);
  if (!columns) return columns.error();
  for (std::size_t r = 1; r < rows.size(); ++r) {
    const CsvRow& row = rows[r];
    if (row.fields.size() > rows.front().fields.size() || row.fields.size() < 4)
      return error_at_line(where, row.line,
                           fmt::format("has {} fields, the header {}; put a field with a comma in "
                                       "quotes",
                                       row.fields.size(), rows.front().fields.size()));
    const auto field = [&](Column column) {
      const int at = (*columns)[column];
      return at >= 0 && at < static_cast<int>(row.fields.size()) ? row.fields[static_cast<std::size_t>(at)]
                                                                 : std::string();
    };
    const auto start_s = seconds(field(Start), "the start", where, row.line);
    if (!start_s) return start_s.error();
    const auto end_s = seconds(field(End), "the end", where, row.line);
    if (!end_s) return end_s.error();
    if (*end_s <= *start_s)
      return error_at_line(where, row.line,
                           fmt::format("ends at {} s, which is not after its start at {} s; end is exclusive",
                                       *end_s, *start_s));
    if (field(TierName).empty()) return error_at_line(where, row.line, "the tier is empty; name it");
    tiers.named(field(TierName))
        .intervals.push_back({*start_s, *end_s, field(Value), field(Detail), field(Confidence)});
  }
  document.tiers = tiers.taken();
  return document;
}

Result<TierDocument> parse_label_file(std::string_view text, std::string_view where,
                                      const TierReading& reading) {
  TierDocument document;
  const std::vector<std::string> takes = takes_in_labels(text);
  document.take = reading.take;
  if (document.take.empty()) {
    if (takes.size() != 1)
      return Error{takes.empty() ? "has no labels; expected lines take,start_frame,end_frame,label"
                                 : fmt::format("has labels of {} takes: {}; name one of them", takes.size(),
                                               fmt::join(takes, ", ")),
                   std::string(where)};
    document.take = takes.front();
  }
  const auto labels = parse_labels(text, document.take, where);
  if (!labels) return labels.error();
  if (!(reading.fps > 0))
    return Error{"counts frames; give their rate", std::string(where), Hint::SetFrameRate};
  if (labels->empty())
    document.warnings.push_back(
        fmt::format("has no labels of the take {}; it has {}", document.take, fmt::join(takes, ", ")));
  Tier tier{"move", {}, {}, TierKind::Move};
  for (const LabelInterval& label : *labels) tier.intervals.push_back(interval_of(label, reading.fps));
  document.tiers.push_back(std::move(tier));
  return document;
}

bool has_tier_header(const std::vector<CsvRow>& rows) {
  const auto& titles = rows.front().fields;
  return std::any_of(titles.begin(), titles.end(),
                     [](const std::string& t) { return lower_case(t) == "tier"; });
}

const Tier* tier_of_moves(std::span<const Tier> tiers) {
  for (const Tier& tier : tiers)
    if (tier.kind == TierKind::Move) return &tier;
  return tiers.size() == 1 ? &tiers.front() : nullptr;
}

}  // namespace

Result<TierDocument> parse_tier_csv(std::string_view text, std::string_view where,
                                    const TierReading& reading) {
  const auto rows = parse_csv(text, where);
  if (!rows) return rows.error();
  if (rows->empty())
    return Error{"is empty; expected a table tier,start,end,value or take,start_frame,end_frame,label",
                 std::string(where)};
  if (is_elan_table(text)) return parse_elan_table(text, where);
  return has_tier_header(*rows) ? parse_exchange(*rows, where) : parse_label_file(text, where, reading);
}

bool is_tier_csv(std::string_view text) {
  const auto rows = parse_csv(text, "");
  return rows && !rows->empty() && has_tier_header(*rows);
}

TierText tier_csv(std::span<const Tier> tiers) {
  TierText written{"tier,start,end,value,detail,confidence\n", {}};
  int empty = 0, vocabularies = 0;
  for (const Tier& tier : tiers) {
    empty += tier.intervals.empty() ? 1 : 0;
    vocabularies += tier.vocabulary.empty() ? 0 : 1;
    for (const TierInterval& one : tier.intervals)
      written.text += fmt::format("{},{},{},{},{},{}\n", csv_field(tier.name), exact_text(one.start_s),
                                  exact_text(one.end_s), csv_field(one.value), csv_field(one.detail),
                                  csv_field(one.confidence));
  }
  if (empty > 0)
    written.warnings.push_back(
        fmt::format("{} empty {} left out", empty, empty == 1 ? "tier was" : "tiers were"));
  if (vocabularies > 0)
    written.warnings.push_back(fmt::format("the vocabulary of {} {} left out; .eaf and .json keep it",
                                           vocabularies, vocabularies == 1 ? "tier was" : "tiers was"));
  return written;
}

Result<TierText> label_csv(std::span<const Tier> tiers, std::string_view where, const TierWriting& writing) {
  if (!(writing.fps > 0))
    return Error{"a label file counts frames; give their rate", std::string(where), Hint::SetFrameRate};
  const Tier* moves = tier_of_moves(tiers);
  if (!moves) return Error{"a label file holds one tier; say which", std::string(where)};
  TierText written{"take,start_frame,end_frame,label,detail,confidence\n", {}};
  int left_out = 0;
  for (const TierInterval& one : moves->intervals) {
    const long long start = std::llround(one.start_s * writing.fps),
                    end = std::llround(one.end_s * writing.fps);
    if (start < 0 || end <= start || one.value.empty())
      ++left_out;
    else
      written.text += fmt::format("{},{},{},{},{},{}\n", csv_field(writing.take), start, end,
                                  csv_field(one.value), csv_field(one.detail), csv_field(one.confidence));
  }
  if (left_out > 0)
    written.warnings.push_back(
        fmt::format("{} of {} intervals were left out: shorter than a frame, before the "
                    "first one, or without a label",
                    left_out, moves->intervals.size()));
  if (tiers.size() > 1)
    written.warnings.push_back(fmt::format("a label file holds one tier, here {}; {} left out",
                                           in_quotes(moves->name), tiers.size() - 1));
  return written;
}

Result<TierText> audacity_labels(std::span<const Tier> tiers, std::string_view where) {
  const Tier* moves = tier_of_moves(tiers);
  for (const Tier& tier : tiers)
    if (!moves && !tier.intervals.empty()) moves = &tier;
  if (!moves) return Error{"has no labels to write", std::string(where)};
  TierText written;
  int remarks = 0;
  for (const TierInterval& one : moves->intervals) {
    if (one.value.find_first_of("\t\r\n") != std::string::npos)
      return Error{fmt::format("a label track holds no tabs and line ends, found {}", in_quotes(one.value)),
                   std::string(where)};
    remarks += one.detail.empty() && one.confidence.empty() ? 0 : 1;
    written.text += fmt::format("{:.6f}\t{:.6f}\t{}\n", one.start_s, one.end_s, one.value);
  }
  if (remarks > 0)
    written.warnings.push_back(fmt::format("detail and confidence of {} interval{} were left out", remarks,
                                           remarks == 1 ? "" : "s"));
  if (tiers.size() > 1)
    written.warnings.push_back(fmt::format("a label track holds one tier, here {}; {} left out",
                                           in_quotes(moves->name), tiers.size() - 1));
  return written;
}

}  // namespace abrazo
