#pragma once

#include <string>
#include <vector>

#include "core/annotation/annotations.hpp"

namespace abrazo::widgets {

/// What can be done about a problem with one key. Plain arithmetic, no toolkit.
enum class ProblemFix {
  FillFromLeft,   ///< a gap: the annotation before it goes on
  FillFromRight,  ///< the one after it begins earlier
  Remove,
  KeepInRange,      ///< what lies beyond the subject is cut off
  ToFrames,         ///< its edges go to the nearest frames
  AddToVocabulary,  ///< what it says becomes one of the values
};

/// "fill from the left".
std::string words_of(ProblemFix fix);

/// The first one is what Return does.
std::vector<ProblemFix> fixes_of(const AnnotationProblem& problem, const Annotations& annotations);

/// @param fps  of the subject's frames; 0 = not known
Result<Annotations> fixed(const Annotations& annotations, const AnnotationProblem& problem, ProblemFix fix,
                          const Annotations::Range& range, double fps);

}  // namespace abrazo::widgets
