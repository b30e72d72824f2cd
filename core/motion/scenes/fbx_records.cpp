#include "core/motion/scenes/fbx_records.hpp"

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/base/little_endian.hpp"

namespace abrazo {

namespace {

/// A number as Assimp takes it: the digits in front.
std::optional<std::uint64_t> number_in_front(std::string_view word) {
  if (word.empty() || word[0] < '0' || word[0] > '9') return std::nullopt;
  std::uint64_t value = 0;
  for (const char c : word) {
    if (c < '0' || c > '9') break;
    value = value * 10 + static_cast<std::uint64_t>(c - '0');
  }
  return value;
}

/// "Key: value, value {": the parts that concern models.
class LinkCollector {
 public:
  void key(std::string_view name) {
    key_ = name;
    values_.clear();
  }
  void number(std::uint64_t value) {
    values_.push_back(value);
    take();
  }
  /// A name or a kind of connection; properties are connected as well.
  void word() {
    values_.emplace_back();
    take();
  }
  FbxLinks links;

 private:
  void take() {
    if (key_ == "Model" && values_.size() == 1 && values_[0]) links.models.push_back(*values_[0]);
    if (key_ == "C" && values_.size() == 3 && values_[1] && values_[2])
      links.connections.emplace_back(*values_[1], *values_[2]);
  }
  std::string_view key_;
  std::vector<std::optional<std::uint64_t>> values_;
};

/// Strings have no escapes, comments go from ';' to the end of the line.
FbxLinks links_of_text(std::string_view text) {
  LinkCollector collector;
  constexpr std::string_view ends = " \t\r\n\f\v,:;{}\"";
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == ';') {
      at = std::min(text.find_first_of(std::string_view("\n\r\f\0", 4), at), text.size());
    } else if (c == '"') {
      collector.word();
      at = std::min(text.find('"', at + 1), text.size() - 1) + 1;
    } else if (ends.find(c) != std::string_view::npos) {
      ++at;
    } else {
      const std::size_t end = std::min(text.find_first_of(ends, at), text.size());
      const std::string_view word = text.substr(at, end - at);
      at = end;
      if (at < text.size() && text[at] == ':') {
        collector.key(word);
      } else if (const auto number = number_in_front(word)) {
        collector.number(*number);
      } else {
        collector.word();
      }
    }
  }
  return collector.links;
}

/// The first three properties of a record. @param text  they and nothing else
void take_properties(std::string_view text, LinkCollector& collector) {
  std::size_t at = 0;
  for (int p = 0; p < 3 && at < text.size(); ++p) {
    const char type = text[at++];
    if (type == 'L' && at + 8 <= text.size()) {
      collector.number(little_endian(text, at, 8));
      at += 8;
    } else if ((type == 'S' || type == 'R') && at + 4 <= text.size()) {
      collector.word();
      at += 4 + little_endian(text, at, 4);
    } else {
      return;  // neither a model's number nor a connection has any other type
    }
  }
}

/// Records: where it ends, number and bytes of properties (words of 4 bytes, from version 7500 on 8), length
/// of the name, name, properties, records inside, an empty record. One after the other in the order of the
/// file, at any nesting level.
FbxLinks links_of_binary(std::string_view bytes) {
  LinkCollector collector;
  constexpr std::size_t header = 27;
  if (bytes.size() < header) return {};
  const std::size_t word = little_endian(bytes, 23, 4) >= 7500 ? 8 : 4, empty_record = 3 * word + 1;
  for (std::size_t at = header; at + empty_record <= bytes.size();) {
    const std::uint64_t end = little_endian(bytes, at, word),
                        length = little_endian(bytes, at + 2 * word, word);
    const std::size_t name_length = static_cast<unsigned char>(bytes[at + 3 * word]);
    const std::size_t name_at = at + empty_record, properties_at = name_at + name_length;
    if (end == 0) {
      at = name_at;
      continue;
    }
    if (length > bytes.size() || properties_at + length > bytes.size()) break;
    collector.key(bytes.substr(name_at, name_length));
    take_properties(bytes.substr(properties_at, length), collector);
    at = properties_at + length;
  }
  return collector.links;
}

}  // namespace

FbxLinks fbx_links(std::string_view bytes) {
  return bytes.starts_with("Kaydara FBX Binary") ? links_of_binary(bytes) : links_of_text(bytes);
}

}  // namespace abrazo
