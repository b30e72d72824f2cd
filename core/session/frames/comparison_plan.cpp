#include "core/session/frames/comparison_plan.hpp"

#include <algorithm>
#include <tuple>

namespace abrazo {
namespace {

/// From and to; the same time twice is one frame.
std::optional<std::pair<double, double>> span_of(const CompareSituation& now) {
  const double here_s = now.shown->time_s;
  const auto back = [&](double seconds) {
    return std::pair(std::max(now.playback.first_s, here_s - seconds), here_s);
  };
  switch (now.span) {
    case WhatIfSpan::Frame:
      return std::pair(here_s, here_s);
    case WhatIfSpan::TwoSeconds:
      return back(2);
    case WhatIfSpan::TenSeconds:
      return back(10);
    case WhatIfSpan::InToOut:
      break;
  }
  if (!(now.playback.out_s > now.playback.in_s)) return std::nullopt;
  return std::pair(now.playback.in_s, now.playback.out_s);
}

}  // namespace

bool covers(const ComparisonTask& task, double time_s) {
  return !task.follows_live && time_s >= task.from_s && time_s <= task.to_s;
}

std::optional<ComparisonTask> what_if_task(const CompareSituation& now, const ComparisonTask* current) {
  const bool is_following = now.playback.state == Playback::State::Following;
  if (is_following || !now.shown) return std::nullopt;
  if (now.present == now.frozen.value_or(now.shown->settings) && !now.tried_pin) return std::nullopt;
  ComparisonTask task;
  task.a = now.frozen;
  task.b = now.present;
  if (now.tried_pin) {
    task.b_decisions = now.shown->decisions ? *now.shown->decisions : Decisions{};
    task.b_decisions->pinned = now.tried_pin;
  }
  const bool is_range = now.span == WhatIfSpan::InToOut;
  const bool is_same_length =
      current && (now.span == WhatIfSpan::Frame) == (current->from_s == current->to_s);
  if (current && !is_range && is_same_length && current->a == task.a && current->b == task.b &&
      current->b_decisions == task.b_decisions && covers(*current, now.shown->time_s))
    return *current;
  if (now.playback.state == Playback::State::Playing && !is_range) return std::nullopt;
  const auto span = span_of(now);
  if (!span) return std::nullopt;
  std::tie(task.from_s, task.to_s) = *span;
  return task;
}

std::optional<ComparisonTask> shadow_task(const CompareSituation& now, double since_s) {
  if (!now.frozen) return std::nullopt;
  ComparisonTask task;
  (now.is_aside ? task.b : task.a) = now.is_aside ? now.present : *now.frozen;
  task.from_s = task.to_s = since_s;
  task.follows_live = true;
  return task;
}

}  // namespace abrazo
