#include "app/cli/hint_words.hpp"

namespace abrazo::app {

std::string_view option_words(Hint hint) {
  switch (hint) {
    case Hint::None:
      break;
    case Hint::NameSkeleton:
      return " (--skeleton FILE)";
    case Hint::LeaveOutSkeleton:
      return " (--skeleton)";
    case Hint::NameJointMap:
      return " (--joint-map FILE)";
    case Hint::NameJointOrder:
      return ", or with --joints NAME|FILE";
    case Hint::SetUnit:
      return " (--metres-per-unit)";
    case Hint::SetFrameRate:
      return " (--fps)";
    case Hint::SetUpAxis:
      return " (--up)";
    case Hint::ChooseAnimation:
      return "; choose one with --animation NAME";
    case Hint::ChoosePerformer:
      return " (--performer)";
    case Hint::ChoosePreset:
      return " (--preset)";
    case Hint::ChooseFrames:
      return " (--time or --frame; --from, --to or --take)";
    case Hint::EvaluateBothRoles:
      return " (--both-roles)";
    case Hint::NameUsers:
      return " (--users)";
    case Hint::SetSweepAxis:
      return " (--x, --y)";
    case Hint::SetShard:
      return " (--shard)";
    case Hint::ChooseMetric:
      return " (--metric)";
    case Hint::NameReport:
      return " (--report)";
  }
  return "";
}

}  // namespace abrazo::app
