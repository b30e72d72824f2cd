#include "app/workbench/compare/comparison_words.hpp"

#include "app/workbench/base/range_words.hpp"
#include "widgets/compare/figure_rows.hpp"

namespace abrazo::app {
namespace {

QString line(const Settings& own, const Settings& other) {
  return QString::fromStdString(widgets::settings_line(own, other));
}

}  // namespace

widgets::CompareSides sides_of(const CompareSituation& now, double frozen_at_s, const Comparison* shown) {
  const bool is_following = now.playback.state == Playback::State::Following;
  widgets::CompareSides sides;
  sides.is_frozen = now.frozen.has_value();
  sides.is_aside = now.is_aside;
  sides.origin_b = is_following    ? (now.is_aside ? "tried aside" : "live")
                   : now.tried_pin ? "what if, pinned"
                                   : "what if";
  if (now.frozen) {
    sides.origin_a = now.is_aside ? "live, held" : "frozen at " + in_seconds(frozen_at_s, 1);
    sides.settings_a = line(*now.frozen, now.present);
    sides.settings_b = line(now.present, *now.frozen);
  } else if (!is_following && now.shown) {
    sides.origin_a = "as recorded";
    sides.settings_a = line(now.shown->settings, now.present);
    sides.settings_b = line(now.present, now.shown->settings);
  } else {
    sides.origin_a = "not frozen";
    sides.settings_a = "—";
    sides.settings_b = "the settings panel";
  }
  if (shown && !shown->steps.empty()) {
    sides.settings_a = line(shown->settings_a, shown->settings_b);
    sides.settings_b = line(shown->settings_b, shown->settings_a);
    if (!shown->task.follows_live && !shown->task.a) sides.origin_a = "as recorded";
  }
  return sides;
}

QString note_of(const Comparison& comparison) {
  const double length_s = comparison.steps.back().time_s - comparison.steps.front().time_s;
  QString note =
      comparison.steps.size() == 1
          ? QString("One step, from what the solver knew at %1.").arg(in_seconds(comparison.task.from_s, 2))
          : QString("%1 steps over %2, from the same start at %3.")
                .arg(comparison.steps.size())
                .arg(in_seconds(length_s, 1), in_seconds(comparison.task.from_s, 2));
  if (comparison.task.follows_live)
    note = QString("The last %1 with these settings, %2 steps; the runs differ from %3.")
               .arg(in_seconds(length_s, 1))
               .arg(comparison.steps.size())
               .arg(in_seconds(comparison.task.from_s, 1));
  if (comparison.is_short) note += " It begins later than requested: older inputs are no longer kept.";
  if (comparison.unread > 0) note += QString(" %1 of its frames cannot be read.").arg(comparison.unread);
  if (comparison.done) note += QString(" Solved in %1.").arg(in_seconds(comparison.solve_s, 2));
  return note;
}

QString advice(const CompareSituation& now, const Comparison* tried) {
  if (tried && !tried->trouble.empty()) return QString::fromStdString(tried->trouble) + ".";
  const bool is_following = now.playback.state == Playback::State::Following;
  if (!is_following && now.span == WhatIfSpan::InToOut && !(now.playback.out_s > now.playback.in_s))
    return "Mark a range with I and O, or choose another span.";
  if (now.frozen)
    return now.present == *now.frozen ? "A is frozen. Change a setting: what you change is B." : "Solving …";
  return is_following ? "Freeze A, then change settings: A runs beside the live partner. Or park the "
                        "cursor and change "
                        "a setting: the frames before it are solved again."
                      : "Change a setting: the frames here are solved again with it.";
}

}  // namespace abrazo::app
