#include "core/motion/tables/trc_reader.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/line_reader.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/tables/point_rows.hpp"
#include "core/motion/tables/table_line.hpp"

namespace abrazo {

namespace {

constexpr std::size_t most_markers = 10'000;

/// Of all markers in all frames. Rows may be shorter than their markers, but not all of a file's by far.
std::size_t positions_allowed(std::size_t bytes) {
  return std::min<std::size_t>(1'000'000 + 16 * bytes, 400'000'000);
}

/// The fields of a line between separators; of a line without any, its words.
std::vector<std::string_view> fields_of(std::string_view line, char separator) {
  return line.find(separator) == std::string_view::npos ? split_words(line) : split_fields(line, separator);
}

class TrcParser {
 public:
  TrcParser(std::string_view text, std::string_view where)
      : lines_(text), where_(where), most_positions_(positions_allowed(text.size())) {}
  Result<std::vector<NamedMotion>> parse();

 private:
  Status read_header();
  Status read_names(std::string_view line);
  Status read_rows(PointRows& rows);
  Status note_short_row(std::size_t frames_before);
  std::optional<double> header_number(const std::string& name) const;
  void check_counts(std::size_t frames);
  void settle(NamedMotion& motion) const;
  void warn(std::string kind, int line, std::string detail) {
    warnings_.push_back({std::move(kind), line, std::move(detail)});
  }
  Error error(std::string message) const { return error_at(where_, lines_.number(), std::move(message)); }

  LineReader lines_;
  std::string where_;
  std::size_t most_positions_;
  char separator_ = '\t';
  std::map<std::string, std::string> header_;
  int header_line_ = 0;
  int short_rows_ = 0, first_short_row_ = 0;
  std::vector<PointColumn> columns_;
  std::vector<ImportWarning> warnings_;
};

Status TrcParser::read_header() {
  std::string_view line, names, values;
  if (!lines_.next(line))
    return Error{"is empty; expected a TRC file, which begins with PathFileType", where_};
  if (!lower_case(line.substr(0, 40)).starts_with("pathfiletype"))
    return error("expected a TRC file, which begins with PathFileType, found " + in_quotes(line));
  if (!lines_.next(names) || !lines_.next(values))
    return error(
        "ends in its header; expected a line of names (DataRate, ...), one of values, and one of markers");
  header_line_ = lines_.number();
  separator_ = table_separator(names, '\t');
  auto name_fields = fields_of(names, separator_), value_fields = fields_of(values, separator_);
  // Some programs write two separators between values: then the n-th value belongs to the n-th name.
  const auto words = [](const std::vector<std::string_view>& fields) {
    return std::ranges::count_if(fields, [](std::string_view field) { return !field.empty(); });
  };
  if (words(name_fields) == words(value_fields))
    for (auto* fields : {&name_fields, &value_fields})
      std::erase_if(*fields, [](std::string_view field) { return field.empty(); });
  for (std::size_t i = 0; i < name_fields.size() && i < value_fields.size(); ++i)
    header_[lower_case(name_fields[i])] = std::string(value_fields[i]);
  while (lines_.next(line)) {
    if (trimmed(line).empty()) continue;
    return read_names(line);
  }
  return error("ends before the line of marker names, which begins with Frame#");
}

/// "Frame# Time LASI RASI ...": a marker's name is above its x.
Status TrcParser::read_names(std::string_view line) {
  if (const char here = table_separator(line, '\t'); line.find(here) != std::string_view::npos)
    separator_ = here;
  const auto fields = fields_of(line, separator_);
  if (fields.empty() || !lower_case(fields[0]).starts_with("frame"))
    return error("expected the line of marker names, which begins with Frame# and Time, found " +
                 in_quotes(line));
  const bool spread = line.find(std::string(2, separator_)) != std::string_view::npos;
  std::size_t next = 2;
  for (std::size_t f = 2; f < fields.size(); ++f) {
    if (fields[f].empty()) continue;
    const std::size_t x = spread ? f : next;
    columns_.push_back({std::string(fields[f]), {x, x + 1, x + 2}});
    next += 3;
  }
  if (columns_.empty()) return error("names no marker behind Frame# and Time");
  if (columns_.size() > most_markers)
    return error("names " + std::to_string(columns_.size()) + " markers; at most " +
                 std::to_string(most_markers) + " can be read");
  std::vector<std::string> names;
  for (const PointColumn& column : columns_) names.push_back(column.name);
  make_names_unique(names, "marker", warnings_);
  for (std::size_t c = 0; c < columns_.size(); ++c) columns_[c].name = names[c];
  return Done{};
}

/// Programs leave out the fields behind the last marker that was seen.
Status TrcParser::note_short_row(std::size_t frames_before) {
  if (short_rows_++ == 0) first_short_row_ = lines_.number();
  if (frames_before < most_positions_ / columns_.size()) return Done{};
  return error("has " + std::to_string(short_rows_) + " rows with fewer fields than its " +
               std::to_string(columns_.size()) +
               " markers have, and would need more memory than a file of its size can be worth; export it "
               "with a field for every coordinate, or with the markers that were seen");
}

Status TrcParser::read_rows(PointRows& rows) {
  const std::size_t expected = columns_.back().fields[2] + 1;
  std::string_view line;
  while (lines_.next(line)) {
    if (trimmed(line).empty()) continue;
    const auto fields = fields_of(line, separator_);
    if (std::ranges::all_of(fields, [](std::string_view field) { return field.empty(); })) continue;
    if (!parse_number(fields[0])) {
      if (rows.frames() == 0) continue;  // X1 Y1 Z1 ... below the names
      return error("expected a frame number, found " + in_quotes(fields[0]));
    }
    std::size_t used = fields.size();
    while (used > expected && fields[used - 1].empty()) --used;
    if (used > expected)
      return error("expected at most " + std::to_string(expected) +
                   " fields (frame, time and 3 for each of " + std::to_string(columns_.size()) +
                   " markers), found " + std::to_string(used));
    const bool cut_off = lines_.rest().empty() && rows.frames() > 0 && fields.size() + 3 <= expected;
    if (cut_off) {
      warn("truncated", lines_.number(),
           "the file ends inside a frame; the " + std::to_string(rows.frames()) + " whole frames were kept");
      return Done{};
    }
    if (fields.size() < expected)
      if (const Status noted = note_short_row(rows.frames()); !noted) return noted;
    if (const Status added = rows.add(fields, where_, lines_.number()); !added) return added.error();
  }
  return Done{};
}

std::optional<double> TrcParser::header_number(const std::string& name) const {
  const auto found = header_.find(name);
  return found == header_.end() ? std::nullopt : parse_number(found->second);
}

void TrcParser::check_counts(std::size_t frames) {
  const auto compare = [&](const char* name, std::size_t there, const char* what) {
    const auto said = header_number(name);
    if (said && *said == static_cast<double>(there)) return;
    warn(std::string(what) + "-count", header_line_,
         said ? "the header announces " + header_.at(name) + " " + what + "s and there are " +
                    std::to_string(there) + "; those were read"
              : std::string("the header does not say how many ") + what + "s there are; " +
                    std::to_string(there) + " were read");
  };
  compare("numframes", frames, "frame");
  compare("nummarkers", columns_.size(), "marker");
}

void TrcParser::settle(NamedMotion& motion) const {
  const auto rate = header_number("datarate");
  if (rate && *rate > 0 && std::isfinite(*rate))
    motion.fps = *rate;
  else
    motion.warnings.push_back({"frame-time", header_line_,
                               motion.fps ? "the header gives no DataRate; " + exact_text(*motion.fps) +
                                                " fps was found from the times"
                                          : "the header gives no DataRate"});
  const auto unit = header_.find("units");
  if (unit != header_.end()) motion.metres_per_unit = metres_of_unit(unit->second);
  if (unit != header_.end() && !motion.metres_per_unit)
    motion.warnings.push_back(
        {"unit", header_line_, "the unit " + in_quotes(unit->second) + " is not known"});
}

Result<std::vector<NamedMotion>> TrcParser::parse() {
  if (const Status header = read_header(); !header) return header.error();
  PointRows rows(columns_, 1);
  if (const Status read = read_rows(rows); !read) return read.error();
  if (rows.frames() == 0) return error("has no frames below its header");
  if (short_rows_ > 0)
    warn("short-row", first_short_row_,
         std::to_string(short_rows_) + (short_rows_ == 1 ? " row ends" : " rows end") +
             " before the last marker; the markers behind were taken as not seen");
  check_counts(rows.frames());
  NamedMotion motion = rows.take();
  motion.warnings.insert(motion.warnings.begin(), warnings_.begin(), warnings_.end());
  settle(motion);
  motion.name = stem_of(where_);
  return split_performers(std::move(motion));
}

}  // namespace

Result<std::vector<NamedMotion>> read_trc(std::string_view text, std::string_view where) {
  return TrcParser(text, where).parse();
}

}  // namespace abrazo
