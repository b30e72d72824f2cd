#include "core/session/export/exporting.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/output_file.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/motion/scenes/character_glb.hpp"
#include "core/session/export/export_parts.hpp"

namespace abrazo {

namespace {

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " or " : ", ") + words[i];
  return text;
}

std::string kind_name(ExportContent content) {
  switch (content) {
    case ExportContent::Mesh:
      return "meshes";
    case ExportContent::Labels:
      return "labels";
    case ExportContent::Trace:
      return "a trace";
    case ExportContent::Motion:
      break;
  }
  return "motion";
}

Status check_motion(const ExportWish& wish) {
  if (wish.performer && wish.bodies != std::vector{SessionBody::User})
    return Error{"what was received of a performer is the user; choose the user alone", wish.output};
  if (wish.bodies.empty()) return Error{"no body is chosen; choose user, active or passive", wish.output};
  auto sorted = wish.bodies;
  std::ranges::sort(sorted);
  if (std::ranges::adjacent_find(sorted) != sorted.end())
    return Error{"a body is requested twice", wish.output};
  if (!wish.character.empty()) {
    if (!wish.space.is_usual() || wish.space.joints)
      return Error{"a character has its own bones, in metres with Y up; leave unit, axes and joints out",
                   wish.output};
    return check_character_file(wish.output);
  }
  return check_clip_file(wish.output, wish.space, wish.bodies.size());
}

constexpr double highest_export_rate_hz = 1000;

}  // namespace

std::vector<std::string> ExportWish::files() const {
  if (character.empty()) return {output};
  std::vector<std::string> all;
  for (const SessionBody body : bodies)
    all.push_back(with_suffix(output, body == SessionBody::User     ? "_user"
                                      : body == SessionBody::Active ? "_active"
                                                                    : "_passive"));
  return all;
}

std::vector<std::string> export_types(ExportContent content) {
  switch (content) {
    case ExportContent::Mesh:
      return {".vtu", ".pvd"};
    case ExportContent::Labels:
      return tier_file_extensions();
    case ExportContent::Trace:
      return {".jsonl"};
    case ExportContent::Motion:
      break;
  }
  return {clip_file_types.begin(), clip_file_types.end()};
}

Status check_export(const ExportWish& wish) {
  const bool is_performed = !wish.character.empty();
  if (is_performed && wish.content != ExportContent::Motion)
    return Error{"a character performs motion, not " + kind_name(wish.content) + "; leave it out",
                 wish.output};
  const auto types = export_types(wish.content);
  const bool fits = is_performed ||
                    std::ranges::any_of(types, [&](const auto& type) { return wish.output.ends_with(type); });
  if (!fits)
    return Error{kind_name(wish.content) + " cannot be written as this file type; use " + listed(types),
                 wish.output};
  if (!(wish.rate_hz <= highest_export_rate_hz))
    return Error{fmt::format("cannot have {} frames a second; choose a rate of at most {} Hz", wish.rate_hz,
                             highest_export_rate_hz),
                 wish.output};
  if (wish.content == ExportContent::Motion) return check_motion(wish);
  if (wish.performer)
    return Error{"only motion is received of a performer; leave the performer out", wish.output};
  if (wish.one_mesh() && wish.output.ends_with(".pvd"))
    return Error{"a .pvd is a series; write the one frame as .vtu", wish.output};
  if (!wish.space.is_usual() || wish.space.joints)
    return Error{
        kind_name(wish.content) + " cannot have unit, axes and joints of choice; those are for motion",
        wish.output};
  if (wish.rate_hz > 0 && wish.content == ExportContent::Trace)
    return Error{"a trace has the frames as they were solved; leave the rate out", wish.output};
  return Done{};
}

Result<ExportReport> export_session(ExportSource& source, const ExportWish& wish, const Progress& progress) {
  if (const Status checked = check_export(wish); !checked) return checked.error();
  switch (wish.content) {
    case ExportContent::Mesh:
      return export_mesh(source, wish, progress);
    case ExportContent::Labels:
      return export_labels(source, wish, progress);
    case ExportContent::Trace:
      return export_trace(source, wish, progress);
    case ExportContent::Motion:
      break;
  }
  return export_motion(source, wish, progress);
}

}  // namespace abrazo
