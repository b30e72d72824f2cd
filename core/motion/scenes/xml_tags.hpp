#pragma once

#include <functional>
#include <string_view>

namespace abrazo {

/// A tag of an XML text as it stands.
struct XmlTag {
  std::string_view name;
  std::string_view inside;  ///< between the name and the '>'
  bool closes = false;      ///< "</name>"
  bool is_empty = false;    ///< "<name/>"

  /// Without its quotes, references not resolved; empty when there is none.
  std::string_view attribute(std::string_view key) const;
};

/// All tags in order; comments, CDATA sections and processing instructions are passed over. Nothing is
/// checked: for a look at a file before a real parser reads it.
void each_xml_tag(std::string_view xml, const std::function<void(const XmlTag&)>& visit);

}  // namespace abrazo
