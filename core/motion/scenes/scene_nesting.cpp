#include "core/motion/scenes/scene_nesting.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/base/little_endian.hpp"
#include "core/motion/scenes/xml_tags.hpp"

namespace abrazo {

namespace {

/// Strings have no escapes, comments go from ';' to the end of the line.
std::size_t nesting_of_fbx_text(std::string_view text) {
  std::size_t depth = 0, greatest = 0;
  bool in_string = false, in_comment = false;
  for (const char c : text) {
    if (in_comment)
      in_comment = c != '\n' && c != '\r' && c != '\f' && c != '\0';
    else if (c == '"')
      in_string = !in_string;
    else if (in_string)
      continue;
    else if (c == ';')
      in_comment = true;
    else if (c == '{')
      greatest = std::max(greatest, ++depth);
    else if (c == '}' && depth > 0)
      --depth;
  }
  return greatest;
}

/// Records: where it ends, number and bytes of properties (words of 4 bytes, from version 7500 on 8), length
/// of the name, name, properties, and records inside that end with an empty one.
std::size_t nesting_of_fbx_binary(std::string_view bytes) {
  constexpr std::size_t header = 27;
  if (bytes.size() < header) return 0;
  const std::size_t word = little_endian(bytes, 23, 4) >= 7500 ? 8 : 4, empty_record = 3 * word + 1;
  std::vector<std::size_t> ends;
  std::size_t at = header, greatest = 0;
  while (at + empty_record <= bytes.size()) {
    if (!ends.empty() && at + empty_record >= ends.back()) {
      at = ends.back();
      ends.pop_back();
      continue;
    }
    const std::uint64_t end = little_endian(bytes, at, word),
                        length = little_endian(bytes, at + 2 * word, word);
    if (end == 0 && ends.empty()) return greatest;
    if (end == 0) {
      at += word;
      continue;
    }
    const std::size_t name = static_cast<unsigned char>(bytes[at + 3 * word]);
    if (end > bytes.size() || length > bytes.size()) return greatest;
    const std::size_t inside = at + empty_record + name + length;
    if (inside > end) return greatest;
    at = inside;
    if (inside == end) continue;
    ends.push_back(end);
    greatest = std::max(greatest, ends.size());
  }
  return greatest;
}

std::size_t nesting_of_xml(std::string_view xml) {
  std::size_t depth = 0, greatest = 0;
  each_xml_tag(xml, [&](const XmlTag& tag) {
    if (tag.closes) {
      if (depth > 0) --depth;
    } else {
      greatest = std::max(greatest, depth + 1);
      if (!tag.is_empty) ++depth;
    }
  });
  return greatest;
}

}  // namespace

std::size_t scene_nesting(std::string_view bytes, MotionFormat format) {
  if (format == MotionFormat::Collada) return nesting_of_xml(bytes);
  if (format == MotionFormat::Fbx)
    return bytes.starts_with("Kaydara FBX Binary") ? nesting_of_fbx_binary(bytes)
                                                   : nesting_of_fbx_text(bytes);
  return 0;
}

}  // namespace abrazo
