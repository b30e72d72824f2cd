#include "core/library/takes/text_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/base/text.hpp"
#include "core/base/utf8.hpp"

namespace abrazo {

namespace {

// ---- reading ----

/// Reads what stands free in the text: numbers, texts in quotes and flags in angle brackets. All other words
/// are titles for people, and are missing in the short form.
class GridReader {
 public:
  GridReader(std::string_view text, std::string_view where) : text_(text), where_(where) {}
  Result<TierDocument> document();

 private:
  struct Token {
    enum class Kind { Number, Text, Flag, End } kind = Kind::End;
    std::size_t line = 0;
    double number = 0;
    std::string text;
  };

  Result<Token> next();
  Result<Token> next_text();
  void skip_blanks();
  Result<double> number(const char* what);
  Result<std::string> words(const char* what);
  Result<std::size_t> count(const char* what);
  Error unexpected(const char* what, const Token& found) const;
  Status read_tier();
  Status read_intervals(Tier& tier, std::size_t count);
  Status skip_points(std::size_t count);

  std::string_view text_;
  std::string_view where_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  TierDocument document_;
  std::size_t points_ = 0;
};

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

void GridReader::skip_blanks() {
  for (; at_ < text_.size() && is_blank(text_[at_]); ++at_) line_ += text_[at_] == '\n' ? 1 : 0;
}

/// A text in quotes, in which two are one; it may have several lines.
Result<GridReader::Token> GridReader::next_text() {
  Token token{Token::Kind::Text, line_, 0, {}};
  for (++at_; at_ < text_.size(); ++at_) {
    if (text_[at_] == '"' && !text_.substr(at_ + 1).starts_with('"')) return ++at_, token;
    if (text_[at_] == '"') ++at_;
    line_ += text_[at_] == '\n' ? 1 : 0;
    token.text += text_[at_];
  }
  return error_at_line(where_, token.line, "the quotes that begin here do not end");
}

Result<GridReader::Token> GridReader::next() {
  while (true) {
    skip_blanks();
    if (at_ == text_.size()) return Token{Token::Kind::End, line_, 0, {}};
    if (text_[at_] == '"') return next_text();
    const std::size_t from = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    const std::string_view word = text_.substr(from, at_ - from);
    if (word.starts_with('!')) at_ = std::min(text_.find('\n', at_), text_.size());  // a remark
    if (word.starts_with('<')) return Token{Token::Kind::Flag, line_, 0, std::string(word)};
    if (const auto number = parse_number(word))
      return Token{Token::Kind::Number, line_, *number, std::string(word)};
  }
}

Error GridReader::unexpected(const char* what, const Token& found) const {
  return error_at_line(
      where_, found.line,
      fmt::format("expected {}, found {}", what,
                  found.kind == Token::Kind::End ? "the end of the file" : in_quotes(found.text)));
}

Result<double> GridReader::number(const char* what) {
  const auto token = next();
  if (!token) return token.error();
  if (token->kind != Token::Kind::Number) return unexpected(what, *token);
  return token->number;
}

Result<std::string> GridReader::words(const char* what) {
  auto token = next();
  if (!token) return token.error();
  if (token->kind != Token::Kind::Text) return unexpected(what, *token);
  return std::move(token->text);
}

Result<std::size_t> GridReader::count(const char* what) {
  const auto token = next();
  if (!token) return token.error();
  const auto whole = parse_integer(token->text);
  if (token->kind != Token::Kind::Number || !whole || *whole < 0) return unexpected(what, *token);
  return static_cast<std::size_t>(*whole);
}

Status GridReader::read_intervals(Tier& tier, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto start_s = number("the begin of an interval in seconds");
    if (!start_s) return start_s.error();
    const auto end_s = number("the end of an interval in seconds");
    if (!end_s) return end_s.error();
    auto value = words("the text of an interval in quotes");
    if (!value) return value.error();
    if (!trimmed(*value).empty()) tier.intervals.push_back({*start_s, *end_s, std::move(*value)});
  }
  return Done{};
}

Status GridReader::skip_points(std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (const auto time_s = number("the time of a point in seconds"); !time_s) return time_s.error();
    if (const auto mark = words("the text of a point in quotes"); !mark) return mark.error();
  }
  points_ += count;
  return Done{};
}

Status GridReader::read_tier() {
  const auto type = words("\"IntervalTier\" or \"TextTier\"");
  if (!type) return type.error();
  if (*type != "IntervalTier" && *type != "TextTier")
    return error_at_line(where_, line_,
                         "expected \"IntervalTier\" or \"TextTier\", found " + in_quotes(*type));
  auto name = words("the name of a tier in quotes");
  if (!name) return name.error();
  for (const char* bound : {"the begin of a tier in seconds", "the end of a tier in seconds"})
    if (const auto time_s = number(bound); !time_s) return time_s.error();
  const auto entries = count("the number of intervals of a tier");
  if (!entries) return entries.error();
  if (*type == "TextTier") return skip_points(*entries);
  const TierKind kind = kind_of_name(*name);
  Tier tier{std::move(*name), {}, {}, kind};
  if (const Status read = read_intervals(tier, *entries); !read) return read;
  document_.tiers.push_back(std::move(tier));
  return Done{};
}

Result<TierDocument> GridReader::document() {
  const auto file = words("\"ooTextFile\"");
  if (!file) return file.error();
  const auto type = words("\"TextGrid\"");
  if (!type) return type.error();
  if (!file->starts_with("ooText") || *type != "TextGrid")
    return error_at_line(where_, line_,
                         "is not a TextGrid: expected the types \"ooTextFile\" and \"TextGrid\"");
  for (const char* bound : {"the begin of the grid in seconds", "the end of the grid in seconds"})
    if (const auto time_s = number(bound); !time_s) return time_s.error();
  const auto flag = next();
  if (!flag) return flag.error();
  if (flag->text == "<absent>") return std::move(document_);
  if (flag->kind != Token::Kind::Flag) return unexpected("<exists> or <absent>", *flag);
  const auto tiers = count("the number of tiers");
  if (!tiers) return tiers.error();
  for (std::size_t i = 0; i < *tiers; ++i)
    if (const Status read = read_tier(); !read) return read.error();
  if (points_ > 0)
    document_.warnings.push_back(fmt::format("{} point{} without length {} left out", points_,
                                             points_ == 1 ? "" : "s", points_ == 1 ? "was" : "were"));
  return std::move(document_);
}

// ---- writing ----

std::string grid_text(std::string_view text) {
  std::string in_quotes = "\"";
  for (const char c : text) in_quotes += c == '"' ? std::string("\"\"") : std::string(1, c);
  return in_quotes + '"';
}

/// The intervals of a tier and the gaps between them, from one time to another.
std::vector<TierInterval> without_gaps(const Tier& tier, double from_s, double to_s) {
  std::vector<TierInterval> all;
  double at_s = from_s;
  for (const TierInterval& one : tier.intervals) {
    if (one.start_s > at_s) all.push_back({at_s, one.start_s, ""});
    all.push_back(one);
    at_s = one.end_s;
  }
  if (to_s > at_s || all.empty()) all.push_back({at_s, to_s, ""});
  return all;
}

void count_what_has_no_place(std::span<const Tier> tiers, std::vector<std::string>& warnings) {
  std::ptrdiff_t nameless = 0, remarks = 0, vocabularies = 0;
  for (const Tier& tier : tiers) {
    vocabularies += tier.vocabulary.empty() ? 0 : 1;
    nameless +=
        std::ranges::count_if(tier.intervals, [](const auto& one) { return trimmed(one.value).empty(); });
    remarks += std::ranges::count_if(
        tier.intervals, [](const auto& one) { return !one.detail.empty() || !one.confidence.empty(); });
  }
  if (vocabularies > 0)
    warnings.push_back(fmt::format("the vocabulary of {} tier{} left out; .eaf and .json keep it",
                                   vocabularies, vocabularies == 1 ? " was" : "s was"));
  if (nameless > 0)
    warnings.push_back(fmt::format("{} interval{} without a value {} a gap", nameless,
                                   nameless == 1 ? "" : "s", nameless == 1 ? "is" : "are"));
  if (remarks > 0)
    warnings.push_back(fmt::format("detail and confidence of {} interval{} were left out", remarks,
                                   remarks == 1 ? "" : "s"));
}

}  // namespace

Result<TierDocument> parse_text_grid(std::string_view bytes, std::string_view where) {
  const std::optional<std::string> text = utf8_of(bytes);
  if (!text) return Error{"is not UTF-8 or UTF-16 text; save it as UTF-8", std::string(where)};
  return GridReader(*text, where).document();
}

TierText text_grid(std::span<const Tier> tiers) {
  double from_s = 0, to_s = 0;
  for (const Tier& tier : tiers)
    if (!tier.intervals.empty()) {
      from_s = std::min(from_s, tier.intervals.front().start_s);
      to_s = std::max(to_s, tier.intervals.back().end_s);
    }
  if (!(to_s > from_s)) to_s = from_s + 1;  // Praat opens no grid without length
  const auto span = [](int indent, double start_s, double end_s) {
    return fmt::format("{0:{1}}xmin = {2}\n{0:{1}}xmax = {3}\n", "", indent, exact_text(start_s),
                       exact_text(end_s));
  };
  TierText written;
  written.text = "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\n" + span(0, from_s, to_s) +
                 fmt::format("tiers? <exists>\nsize = {}\nitem []:\n", tiers.size());
  for (std::size_t t = 0; t < tiers.size(); ++t) {
    const auto intervals = without_gaps(tiers[t], from_s, to_s);
    written.text += fmt::format("    item [{}]:\n        class = \"IntervalTier\"\n        name = {}\n{}",
                                t + 1, grid_text(tiers[t].name), span(8, from_s, to_s));
    written.text += fmt::format("        intervals: size = {}\n", intervals.size());
    for (std::size_t i = 0; i < intervals.size(); ++i)
      written.text +=
          fmt::format("        intervals [{}]:\n{}            text = {}\n", i + 1,
                      span(12, intervals[i].start_s, intervals[i].end_s), grid_text(intervals[i].value));
  }
  count_what_has_no_place(tiers, written.warnings);
  return written;
}

}  // namespace abrazo
