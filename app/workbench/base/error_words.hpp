#pragma once

#include <QString>
#include <string_view>

#include "core/base/error.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::app {

/// What the window offers for a hint, as the end of a sentence.
inline std::string_view window_words(Hint hint) {
  switch (hint) {
    case Hint::NameSkeleton:
    case Hint::NameJointMap:
      return " (open it together with the motion)";
    case Hint::None:
    case Hint::LeaveOutSkeleton:
    case Hint::NameJointOrder:
    case Hint::SetUnit:
    case Hint::SetFrameRate:
    case Hint::SetUpAxis:
    case Hint::ChooseAnimation:
    case Hint::ChoosePerformer:
    case Hint::ChoosePreset:
    case Hint::ChooseFrames:
    case Hint::EvaluateBothRoles:
    case Hint::NameUsers:
    case Hint::SetSweepAxis:
    case Hint::SetShard:
    case Hint::ChooseMetric:
    case Hint::NameReport:
      break;
  }
  return "";
}

/// An error in the words of the window.
inline QString words(const Error& error) {
  return widgets::text(error.text(window_words));
}

}  // namespace abrazo::app
