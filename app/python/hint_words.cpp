#include "app/python/hint_words.hpp"

namespace abrazo::python {

std::string_view argument_words(Hint hint) {
  switch (hint) {
    case Hint::None:
    case Hint::ChooseFrames:
    case Hint::SetSweepAxis:
    case Hint::SetShard:
    case Hint::ChooseMetric:
    case Hint::NameReport:
      break;
    case Hint::NameSkeleton:
    case Hint::LeaveOutSkeleton:
      return " (skeleton)";
    case Hint::NameJointMap:
      return " (joint_map)";
    case Hint::NameJointOrder:
      return ", or with the argument joints";
    case Hint::SetUnit:
      return " (metres_per_unit)";
    case Hint::SetFrameRate:
      return " (fps)";
    case Hint::SetUpAxis:
      return " (up)";
    case Hint::ChooseAnimation:
      return "; choose one with the argument animation";
    case Hint::ChoosePerformer:
      return " (performer)";
    case Hint::ChoosePreset:
      return " (preset)";
    case Hint::EvaluateBothRoles:
      return " (both_roles)";
    case Hint::NameUsers:
      return " (users)";
  }
  return "";
}

}  // namespace abrazo::python
