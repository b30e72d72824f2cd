#pragma once

#include <string>
#include <vector>

#include "core/annotation/annotations.hpp"

namespace abrazo::widgets {

/// A fix of a problem by one key. Independent of Qt.
enum class ProblemFix {
  FillFromLeft,   ///< a gap: extends the annotation before it
  FillFromRight,  ///< extends the annotation after it
  Remove,
  KeepInRange,      ///< cuts off the part beyond the subject
  ToFrames,         ///< moves its edges to the nearest frames
  AddToVocabulary,  ///< adds its value to the vocabulary
};

/// "fill from the left".
std::string words_of(ProblemFix fix);

/// The first one is the effect of Return.
std::vector<ProblemFix> fixes_of(const AnnotationProblem& problem, const Annotations& annotations);

/// @param fps of the subject's frames; 0 = unknown
Result<Annotations> fixed(const Annotations& annotations, const AnnotationProblem& problem, ProblemFix fix,
                          const Annotations::Range& range, double fps);

}  // namespace abrazo::widgets
