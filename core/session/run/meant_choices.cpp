#include "core/session/run/meant_choices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace abrazo {

namespace {

std::string quoted(const std::string& label) {
  return label.empty() ? "(no label)" : "\"" + label + "\"";
}

std::string listed(const std::map<std::string, int, std::less<>>& counts) {
  std::string text;
  for (const auto& [name, pairs] : counts)
    text += fmt::format("{}{} ({} pairs)", text.empty() ? "" : ", ", quoted(name), pairs);
  return text;
}

}  // namespace

std::vector<MeantChoice> meant_choices(const RoleViews& views, UserRole user_role, const FrameResult* frame) {
  const MotionLibrary& library = *views.of(user_role).library;
  std::map<std::string, MeantChoice, std::less<>> by_label;
  std::map<std::string, double, std::less<>> nearest;
  const bool has_frame = frame && frame->selected >= 0;
  MeantChoice* choice = nullptr;
  for (const int pair : views.pairs()) {
    const std::string_view label = library.label(pair);
    if (!choice || choice->label != label) {
      choice = &by_label[std::string(label)];
      choice->label = label;
    }
    ++choice->pairs;
    if (!has_frame) continue;
    const double distance = (library.features(pair) - frame->features).norm();
    if (choice->nearest >= 0 && distance >= choice->feature_distance) continue;
    choice->nearest = pair;
    choice->feature_distance = distance;
  }
  std::vector<MeantChoice> choices;
  for (auto& [label, found] : by_label) {
    if (found.nearest >= 0)
      found.pose_distance =
          (library.pose(found.nearest).topRows<joint_count>() - frame->query_normalized).norm() /
          std::sqrt(static_cast<double>(joint_count));
    choices.push_back(std::move(found));
  }
  std::stable_sort(choices.begin(), choices.end(), [](const MeantChoice& a, const MeantChoice& b) {
    return a.feature_distance < b.feature_distance;
  });
  return choices;
}

Status check_meant(const RoleViews& views, const IntendedMove& move) {
  const MotionLibrary& library = *views.library();
  std::map<std::string, int, std::less<>> labels, takes;
  bool any = false;
  for (const int pair : views.pairs()) {
    const std::string_view label = library.label(pair);
    const std::string& take = library.take_of(pair).name;
    const bool has_label = !move.label || *move.label == label;
    const bool has_take = !move.take || *move.take == take;
    any = any || (has_label && has_take);
    if (has_take) ++labels[std::string(label)];
    if (has_label) ++takes[take];
  }
  if (any) return Done{};
  if (move.take && (takes.empty() || !move.label || library.find_take(*move.take) < 0))
    return Error{"there is no pair of this take to select from; there is " +
                     (takes.empty() ? std::string("none with this label either") : listed(takes)),
                 *move.take};
  return Error{"no recorded pair that may be selected has this label; there is " + listed(labels),
               move.label.value_or("")};
}

}  // namespace abrazo
