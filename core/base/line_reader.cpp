#include "core/base/line_reader.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace abrazo {

namespace {
bool is_white(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r' || c == '\n';
}
}  // namespace

LineReader::LineReader(std::string_view text) : rest_(text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  ++number_;
  const auto is_end = [](char c) { return c == '\n' || c == '\r'; };
  const auto end = static_cast<std::size_t>(std::find_if(rest_.begin(), rest_.end(), is_end) - rest_.begin());
  line = rest_.substr(0, end);
  const bool crlf = end + 1 < rest_.size() && rest_[end] == '\r' && rest_[end + 1] == '\n';
  rest_.remove_prefix(std::min(rest_.size(), end + (crlf ? 2 : 1)));
  return true;
}

std::string_view take_word(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size() && is_white(rest[begin])) ++begin;
  std::size_t end = begin;
  while (end < rest.size() && !is_white(rest[end])) ++end;
  const std::string_view word = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return word;
}

Error error_at(std::string_view where, int line, std::string message) {
  return Error{std::move(message), std::string(where) + ":" + std::to_string(line)};
}

std::string stem_of(std::string_view where) {
  return std::filesystem::path(where).stem().string();
}

}  // namespace abrazo
