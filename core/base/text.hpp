#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace abrazo {

/// Without white space (and carriage returns) at both ends.
std::string_view trimmed(std::string_view text);

/// Lower-case copy (ASCII).
std::string lower_case(std::string_view text);

/// A text that ends with the expression, whose parts would outlive it.
template <typename Text>
concept PassingText = std::same_as<Text, std::string>;
template <PassingText Text>
std::vector<std::string_view> split_words(Text&& line) = delete;
template <PassingText Text>
std::vector<std::string_view> split_fields(Text&& line, char separator) = delete;
template <PassingText Text>
std::vector<std::string_view> split_lines(Text&& text) = delete;

/// The words between runs of blanks and tabs.
std::vector<std::string_view> split_words(std::string_view line);

/// The fields between `separator`s, trimmed; an empty line has one empty field.
std::vector<std::string_view> split_fields(std::string_view line, char separator);

/// The lines of a text whose ends are LF, CRLF or CR; the last may lack one.
std::vector<std::string_view> split_lines(std::string_view text);

/// The word between quotes for a message: unprintable characters become '?', a long word is cut.
std::string in_quotes(std::string_view word);

/// A whole word as a number, independent of the locale; none if any character is left over.
std::optional<double> parse_number(std::string_view word);
std::optional<long long> parse_integer(std::string_view word);

/// Shortest decimal text that reads back to the same double.
std::string exact_text(double value);

}  // namespace abrazo
