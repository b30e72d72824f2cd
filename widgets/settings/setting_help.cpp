#include "widgets/settings/setting_help.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "core/base/text.hpp"
#include "widgets/common/typeset.hpp"

namespace abrazo::widgets {
namespace {

using Kind = SettingInfo::Kind;

std::string joined(const std::vector<std::string_view>& words) {
  std::string text;
  for (const std::string_view word : words) text += (text.empty() ? "" : ", ") + std::string(word);
  return text;
}

bool is_number(const SettingInfo& info) {
  return info.kind == Kind::Real || info.kind == Kind::Integer;
}

std::string with_unit(const SettingInfo& info) {
  return info.unit.empty() ? "" : " " + std::string(info.unit);
}

}  // namespace

std::string preset_values(const SettingInfo& info) {
  std::string text, last;
  bool differ = false;
  for (const std::string_view name : preset_names) {
    const std::string value = setting_text(*preset(name), info.key);
    differ = differ || (!last.empty() && value != last);
    last = value;
    text += (text.empty() ? "" : ", ") + value + with_unit(info) + " (" + std::string(name) + ")";
  }
  return differ ? text : last + with_unit(info);
}

std::string value_range(const SettingInfo& info) {
  if (info.kind == Kind::Flag) return "on, off";
  if (info.kind == Kind::Choice || info.kind == Kind::Body) return joined(split_fields(info.choices, '|'));
  return exact_text(info.minimum) + " to " + exact_text(info.maximum) + with_unit(info);
}

std::string setting_tooltip(const SettingInfo& info) {
  std::string html = "<div><b>" + typeset(info.symbol) + (info.symbol.empty() ? "" : " ") +
                     escaped_html(info.title) + "</b></div>";
  for (const std::string_view line : split_fields(info.help, '\n')) {
    const std::size_t at = static_cast<std::size_t>(line.data() - info.help.data());
    const bool formula = at >= 2 && info.help.substr(at - 2, 2) == "  ";
    html += formula ? "<div style='margin-left: 12px; margin-top: 3px; margin-bottom: 3px'><nobr>" +
                          typeset(line) + "</nobr></div>"
                    : "<div>" + typeset(line) + "</div>";
  }
  html += "<div style='margin-top: 6px'>" + escaped_html(value_range(info)) + " \u00b7 default " +
          escaped_html(preset_values(info)) + "</div>";
  if (is_number(info)) html += "<div>Double-click the slider for the default</div>";
  return html;
}

std::string setting_description(const SettingInfo& info) {
  std::string text;
  for (const std::string_view line : split_fields(info.help, '\n')) text += std::string(line) + " ";
  return text + "Range " + value_range(info) + ", default " + preset_values(info);
}

namespace {

/// With the names of Greek letters, which are hard to type.
std::string spelled_out(std::string_view text) {
  static constexpr std::array<std::pair<std::string_view, std::string_view>, 4> letters = {
      {{"α", "alpha"}, {"Δ", "delta"}, {"λ", "lambda"}, {"κ", "kappa"}}};
  std::string spelled(text);
  for (const auto& [letter, name] : letters)
    for (std::size_t at = 0; (at = spelled.find(letter, at)) != std::string::npos;)
      spelled.replace(at, letter.size(), name);
  return spelled;
}

}  // namespace

bool matches(const SettingInfo& info, std::string_view wanted) {
  std::string where;
  for (const std::string_view part : {info.key, info.symbol, info.title, info.group, info.help})
    where += lower_case(part) + "\n" + lower_case(spelled_out(part)) + "\n";
  const std::string words = lower_case(wanted);
  for (const std::string_view word : split_words(words))
    if (where.find(word) == std::string::npos) return false;
  return true;
}

}  // namespace abrazo::widgets
