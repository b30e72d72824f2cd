#include "core/library/takes/csv_text.hpp"

#include <fmt/format.h>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::size_t most_fields = 64;

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
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

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
  while (!at_end() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  const bool quoted = !at_end() && text_[at_] == '"';
  if (quoted)
    if (const Status read = read_quoted(field); !read) return read;
  const std::size_t from = at_;
  while (!at_line_end() && text_[at_] != ',') ++at_;
  const std::string_view rest = trimmed(text_.substr(from, at_ - from));
  if (quoted && !rest.empty())
    return error(line_,
                 fmt::format("{} follows the quotes of a field; put a comma between", in_quotes(rest)));
  if (!quoted) field = rest;
  if (row.fields.size() == most_fields)
    return error(line_, fmt::format("has more than {} fields; is it a table with commas?", most_fields));
  row.fields.push_back(std::move(field));
  return Done{};
}

Result<std::vector<CsvRow>> CsvReader::rows() {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
  std::vector<CsvRow> rows;
  while (!at_end()) {
    CsvRow row{line_, {}};
    for (bool more = true; more;) {
      if (const Status read = read_field(row); !read) return read.error();
      more = !at_end() && text_[at_] == ',';
      if (more) ++at_;
    }
    skip_line_end();
    if (row.fields.size() > 1 || !row.fields.front().empty()) rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace

Result<std::vector<CsvRow>> parse_csv(std::string_view text, std::string_view where) {
  return CsvReader(text, where).rows();
}

std::string csv_field(std::string_view text) {
  const bool plain = text.find_first_of(",\"\n\r") == std::string_view::npos && trimmed(text) == text;
  if (plain) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace abrazo
