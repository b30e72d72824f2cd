#include "core/library/takes/csv_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/text.hpp"
#include "core/motion/tables/table_line.hpp"

namespace abrazo {

namespace {

constexpr std::size_t most_fields = 64;

/// Whether a spreadsheet would take the text for a formula, or would after one apostrophe is taken away.
bool begins_like_a_formula(std::string_view text) {
  const std::size_t at = text.find_first_not_of('\'');
  return at != std::string_view::npos && std::string_view("=+-@").find(text[at]) != std::string_view::npos;
}

/// Reads field by field.
class CsvReader {
 public:
  CsvReader(std::string_view text, std::string_view where) : text_(text), where_(where) {}
  Result<std::vector<CsvRow>> rows();

 private:
  bool at_end() const { return at_ >= text_.size(); }
  bool at_line_end() const { return at_end() || text_[at_] == '\n' || text_[at_] == '\r'; }
  void skip_line_end();
  Status read_field(CsvRow& row);
  Status read_quoted(std::string& field);
  Error error(std::size_t line, std::string message) const {
    return {std::move(message), fmt::format("{}:{}", where_, line)};
  }

  std::string_view text_;
  std::string_view where_;
  char separator_ = ',';
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

/// "1,5" as a spreadsheet writes it that separates by semicolons.
bool has_decimal_comma(std::string_view field) {
  const std::size_t comma = field.find(',');
  const auto are_digits = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
  };
  return comma != std::string_view::npos && are_digits(field.substr(field.starts_with('-') ? 1 : 0, comma)) &&
         are_digits(field.substr(comma + 1));
}

void CsvReader::skip_line_end() {
  if (at_end()) return;
  if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
  ++at_;
  ++line_;
}

Status CsvReader::read_quoted(std::string& field) {
  const std::size_t begun = line_;
  for (++at_; !at_end(); ++at_) {
    if (text_[at_] == '\n') ++line_;
    if (text_[at_] != '"') {
      field += text_[at_];
    } else if (at_ + 1 < text_.size() && text_[at_ + 1] == '"') {
      field += '"';
      ++at_;
    } else {
      ++at_;
      return Done{};
    }
  }
  return error(begun, "quotes that begin here do not end; close them, or double a quote that is meant");
}

Status CsvReader::read_field(CsvRow& row) {
  std::string field;
  while (!at_end() && (text_[at_] == ' ' || text_[at_] == '\t') && text_[at_] != separator_) ++at_;
  const bool quoted = !at_end() && text_[at_] == '"';
  if (quoted)
    if (const Status read = read_quoted(field); !read) return read;
  const std::size_t from = at_;
  while (!at_line_end() && text_[at_] != separator_) ++at_;
  const std::string_view rest = trimmed(text_.substr(from, at_ - from));
  if (quoted && !rest.empty())
    return error(line_,
                 fmt::format("{} follows the quotes of a field; put a separator between", in_quotes(rest)));
  if (!quoted) field = rest;
  if (!quoted && separator_ == ';' && has_decimal_comma(field)) field.replace(field.find(','), 1, ".");
  if (field.starts_with('\'') && begins_like_a_formula(field)) field.erase(0, 1);
  if (row.fields.size() == most_fields)
    return error(line_, fmt::format("has more than {} fields; is it a table of labels?", most_fields));
  row.fields.push_back(std::move(field));
  return Done{};
}

Result<std::vector<CsvRow>> CsvReader::rows() {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
  const TableSeparator found = separator_of_table(text_.substr(at_), ',');
  separator_ = found.separator;
  if (found.stated_length > 0) at_ += found.stated_length, ++line_;
  std::vector<CsvRow> rows;
  while (!at_end()) {
    CsvRow row{line_, {}};
    for (bool more = true; more;) {
      if (const Status read = read_field(row); !read) return read.error();
      more = !at_end() && text_[at_] == separator_;
      if (more) ++at_;
    }
    skip_line_end();
    if (std::ranges::any_of(row.fields, [](const std::string& field) { return !field.empty(); }))
      rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

Result<std::vector<CsvRow>> parse_csv(std::string_view text, std::string_view where) {
  return CsvReader(text, where).rows();
}

std::string csv_field(std::string_view words) {
  const std::string text = (begins_like_a_formula(words) ? "'" : "") + std::string(words);
  const bool plain = text.find_first_of(",\"\n\r") == std::string_view::npos && trimmed(text) == text;
  if (plain) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace abrazo
