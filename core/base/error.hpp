#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace abrazo {

/// What a person can change, which each program offers in its own way: an option, a field of a dialog, an
/// argument. Core's sentences name none of these; a program appends its words for the hint.
enum class Hint {
  None,
  NameSkeleton,
  LeaveOutSkeleton,
  NameJointMap,
  NameJointOrder,
  SetUnit,
  SetFrameRate,
  SetUpAxis,
  ChooseAnimation,
  ChoosePerformer,
  ChoosePreset,
  ChooseFrames,
  EvaluateBothRoles,
  NameUsers,
  SetSweepAxis,
  SetShard,
  ChooseMetric,
  NameReport,
};

/// A program's words for a hint, appended to the sentence as they are: " (--fps HZ)"; empty = none.
using HintWords = std::string_view (*)(Hint hint);

/// Why external data could not be used. Can be shown to a person unchanged.
struct Error {
  std::string message;  ///< what was expected, what was found, what to change
  std::string
      where;  ///< "walk.bvh:17", "packet 812", "manifest.json: takes[3]"; empty when there is no place
  Hint hint = Hint::None;

  /// "where: message", one line.
  std::string text() const;
  /// The same with a program's words for the hint.
  std::string text(HintWords words) const;
};

/// A problem that did not stop the work, one sentence.
struct Warning {
  std::string message;
  Hint hint = Hint::None;

  /// With a program's words for the hint.
  std::string text(HintWords words) const { return message + std::string(words(hint)); }
};

/// Of a line of a text file, counted from 1.
Error error_at_line(std::string_view where, std::size_t line, std::string message);

}  // namespace abrazo
