#include "core/motion/scenes/xml_tags.hpp"

#include <algorithm>
#include <string>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::string_view blanks = " \t\r\n";

/// Past what a mark leads in up to its end; the end of the text where it has none.
std::size_t behind(std::string_view text, std::string_view mark, std::size_t from) {
  const std::size_t found = text.find(mark, from);
  return found == std::string_view::npos ? text.size() : found + mark.size();
}

/// Where a tag ends: a '>' outside of quotes.
std::size_t end_of_tag(std::string_view xml, std::size_t at) {
  while (at < xml.size() && xml[at] != '>') {
    if (xml[at] == '"' || xml[at] == '\'') at = std::min(xml.find(xml[at], at + 1), xml.size() - 1);
    ++at;
  }
  return at;
}

XmlTag tag_of(std::string_view text) {
  XmlTag tag;
  if (text.ends_with('/')) tag.is_empty = true, text.remove_suffix(1);
  const std::size_t end = std::min(text.find_first_of(blanks), text.size());
  tag.name = text.substr(0, end);
  tag.inside = text.substr(end);
  return tag;
}

}  // namespace

std::string_view XmlTag::attribute(std::string_view key) const {
  for (std::size_t at = 0; at < inside.size();) {
    const std::size_t equals = inside.find('=', at);
    if (equals == std::string_view::npos) return {};
    const std::string_view found = trimmed(inside.substr(at, equals - at));
    const std::size_t open = inside.find_first_of("\"'", equals);
    if (open == std::string_view::npos) return {};
    const std::size_t close = std::min(inside.find(inside[open], open + 1), inside.size());
    if (found == key) return inside.substr(open + 1, close - open - 1);
    at = close + 1;
  }
  return {};
}

void each_xml_tag(std::string_view xml, const std::function<void(const XmlTag&)>& visit) {
  for (std::size_t at = xml.find('<'); at < xml.size(); at = xml.find('<', at)) {
    const std::string_view rest = xml.substr(at);
    if (rest.starts_with("<!--")) {
      at = behind(xml, "-->", at + 4);
    } else if (rest.starts_with("<![CDATA[")) {
      at = behind(xml, "]]>", at + 9);
    } else if (rest.starts_with("<?")) {
      at = behind(xml, "?>", at + 2);
    } else if (rest.starts_with("<!")) {
      at += 2;
    } else if (rest.starts_with("</")) {
      const std::size_t end = std::min(xml.find('>', at), xml.size());
      XmlTag tag = tag_of(xml.substr(at + 2, end - at - 2));
      tag.closes = true;
      visit(tag);
      at = end;
    } else {
      const std::size_t end = end_of_tag(xml, at + 1);
      visit(tag_of(xml.substr(at + 1, std::min(end, xml.size()) - at - 1)));
      at = end;
    }
  }
}

}  // namespace abrazo
