#include "core/motion/tables/c3d_parameters.hpp"

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

std::string capitals(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

Error at_byte(std::string_view where, std::size_t byte, std::string message) {
  return Error{std::move(message), std::string(where) + ": byte " + std::to_string(byte)};
}

/// Texts have no end mark; bytes after a NUL are leftovers.
std::string clean_text(std::string_view text) {
  text = text.substr(0, text.find('\0'));
  return std::string(trimmed(text));
}

class ParameterParser {
 public:
  ParameterParser(const C3dBytes& bytes, std::size_t end, std::string_view where)
      : bytes_(bytes), end_(end), where_(where) {}
  Status parse(std::size_t at);
  C3dParameters take();

 private:
  struct Entry {
    int group;
    std::string name;
    C3dParameter parameter;
  };
  /// @param at offset of its type
  Result<C3dParameter> parse_value(std::size_t at, const std::string& name);
  void read_numbers(std::size_t at, std::size_t count, C3dParameter& parameter) const;
  void read_texts(std::size_t at, std::size_t count, C3dParameter& parameter) const;

  const C3dBytes& bytes_;
  std::size_t end_;
  std::string_view where_;
  std::size_t value_bytes_ = 0;  ///< of the values so far
  std::map<int, std::string> groups_;
  std::vector<Entry> entries_;
};

void ParameterParser::read_numbers(std::size_t at, std::size_t count, C3dParameter& parameter) const {
  parameter.numbers.reserve(count);
  for (std::size_t i = 0; i < count; ++i) switch (parameter.type) {
      case 1:
        parameter.numbers.push_back(static_cast<std::int8_t>(bytes_.byte(at + i)));
        break;
      case 2:
        parameter.numbers.push_back(bytes_.integer(at + 2 * i));
        break;
      default:
        parameter.numbers.push_back(static_cast<double>(bytes_.real(at + 4 * i)));
    }
}

void ParameterParser::read_texts(std::size_t at, std::size_t count, C3dParameter& parameter) const {
  const std::size_t length = parameter.dimensions.size() < 2 ? count : parameter.dimensions.front();
  if (length == 0) return;
  for (std::size_t i = 0; i < count; i += length)
    parameter.texts.push_back(clean_text(bytes_.text(at + i, length)));
}

Result<C3dParameter> ParameterParser::parse_value(std::size_t at, const std::string& name) {
  C3dParameter parameter;
  if (at + 2 > end_) return at_byte(where_, at, "the parameters end inside " + in_quotes(name));
  parameter.type = static_cast<std::int8_t>(bytes_.byte(at));
  const std::size_t dimensions = bytes_.byte(at + 1);
  if (parameter.type != -1 && parameter.type != 1 && parameter.type != 2 && parameter.type != 4)
    return at_byte(where_, at,
                   "the parameter " + in_quotes(name) + " is of type " + std::to_string(parameter.type) +
                       "; expected -1 (text), 1, 2 or 4 bytes. The file is damaged here; export it again");
  if (dimensions > 7)
    return at_byte(where_, at + 1,
                   "the parameter " + in_quotes(name) + " has " + std::to_string(dimensions) +
                       " dimensions; at most 7 are allowed. The file is damaged here; export it again");
  at += 2;
  std::size_t count = 1;
  for (std::size_t d = 0; d < dimensions; ++d) {
    if (at >= end_) return at_byte(where_, at, "the parameters end inside " + in_quotes(name));
    parameter.dimensions.push_back(bytes_.byte(at++));
    count *= parameter.dimensions.back();
    if (count > end_) break;
  }
  const std::size_t width = static_cast<std::size_t>(std::abs(parameter.type));
  if (count > end_ || at + count * width > end_)
    return at_byte(where_, at,
                   "the parameter " + in_quotes(name) + " would need " + std::to_string(count * width) +
                       " bytes or more, and " + std::to_string(end_ > at ? end_ - at : 0) +
                       " are left; the file is cut off or damaged, export it again");
  // An entry may state that the next one begins within its value: the same bytes would be read repeatedly.
  value_bytes_ += count * width;
  if (value_bytes_ > end_)
    return at_byte(where_, at,
                   "the values of the parameters up to " + in_quotes(name) + " take " +
                       std::to_string(value_bytes_) + " bytes, and they end at byte " + std::to_string(end_) +
                       ": they lie over each other. The file is damaged; export it again");
  parameter.type == -1 ? read_texts(at, count, parameter) : read_numbers(at, count, parameter);
  return parameter;
}

/// Each entry has the relative offset of the next; it never points back.
Status ParameterParser::parse(std::size_t at) {
  while (at + 2 < end_) {
    const int length = std::abs(static_cast<std::int8_t>(bytes_.byte(at)));  // negative: locked
    const int group = static_cast<std::int8_t>(bytes_.byte(at + 1));
    if (length == 0) return Done{};
    const std::size_t behind_name = at + 2 + static_cast<std::size_t>(length);
    if (behind_name + 2 > end_)
      return at_byte(where_, at, "the parameters are cut off here; export the file again");
    const std::string name = capitals(clean_text(bytes_.text(at + 2, static_cast<std::size_t>(length))));
    const std::size_t offset = bytes_.word(behind_name);
    if (group < 0) {
      groups_[-group] = name;
    } else if (group > 0) {
      Result<C3dParameter> value = parse_value(behind_name + 2, name);
      if (!value) return value.error();
      entries_.push_back({group, name, std::move(*value)});
    }
    if (offset == 0) return Done{};
    if (offset < 2)
      return at_byte(where_, behind_name,
                     "the parameter behind " + in_quotes(name) +
                         " is stated to begin before it ends; the file is damaged here, export it again");
    at = behind_name + offset;
  }
  return Done{};
}

C3dParameters ParameterParser::take() {
  C3dParameters parameters;
  for (Entry& entry : entries_) {
    const auto group = groups_.find(entry.group);
    if (group != groups_.end())
      parameters.emplace(group->second + ":" + entry.name, std::move(entry.parameter));
  }
  return parameters;
}

}  // namespace

std::uint16_t C3dBytes::word(std::size_t at) const {
  const auto low = byte(at), high = byte(at + 1);
  return static_cast<std::uint16_t>(processor_ == C3dProcessor::Mips ? low << 8 | high : high << 8 | low);
}

float C3dBytes::real(std::size_t at) const {
  const std::uint32_t first = word(at), second = word(at + 2);
  switch (processor_) {
    case C3dProcessor::Intel:
      return std::bit_cast<float>(second << 16 | first);
    case C3dProcessor::Mips:
      return std::bit_cast<float>(first << 16 | second);
    case C3dProcessor::Dec:
      break;
  }
  const std::uint32_t bits = first << 16 | second;
  // A DEC exponent of 0 is the number 0 (or reserved); one of 1 or 2 is too small for a float here.
  return (bits >> 23 & 0xFF) < 3 ? 0.0F : std::bit_cast<float>(bits - (2U << 23));
}

double C3dParameter::count(std::size_t index) const {
  if (index >= numbers.size()) return 0;
  const double number = numbers[index];
  return type == 2 && number < 0 ? number + 65536 : number;
}

Result<C3dParameters> parse_c3d_parameters(const C3dBytes& bytes, std::size_t section, std::size_t end,
                                           std::string_view where, std::vector<ImportWarning>& warnings) {
  ParameterParser parser(bytes, std::min(end, bytes.size()), where);
  const Status parsed = parser.parse(section + 4);
  C3dParameters parameters = parser.take();
  if (parsed) return parameters;
  // The parameters of the points may precede the damage.
  if (!parameters.contains("POINT:LABELS")) return parsed.error();
  warnings.push_back({"parameters", 0, parsed.error().text() + "; what stands before it was used"});
  return parameters;
}

}  // namespace abrazo
