#include "widgets/annotation/problem_fixes.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo::widgets {
namespace {

using Kind = AnnotationProblem::Kind;

constexpr double same_s = 1e-6;

/// The annotations before and after a gap; null if there is none.
struct Sides {
  const Annotation* left = nullptr;
  const Annotation* right = nullptr;
};

Sides sides_of(const AnnotationProblem& gap, const Annotations& annotations) {
  Sides sides;
  const AnnotationTier* tier = annotations.tier(gap.tier);
  if (!tier) return sides;
  for (const Annotation& each : tier->annotations) {
    if (std::abs(each.end_s - gap.start_s) < same_s) sides.left = &each;
    if (std::abs(each.start_s - gap.end_s) < same_s) sides.right = &each;
  }
  return sides;
}

Status add_value(Annotations& next, const AnnotationProblem& problem) {
  const AnnotationTier* tier = next.tier(problem.tier);
  const Annotation* said = next.find(problem.annotation);
  if (!tier || !said) return Error{"no longer exists", "label"};
  auto vocabulary = tier->vocabulary;
  vocabulary.push_back({said->value});
  return next.set_vocabulary(tier->id, std::move(vocabulary));
}

Status apply(Annotations& next, const AnnotationProblem& problem, ProblemFix fix,
             const Annotations::Range& range, double fps) {
  const Sides sides = sides_of(problem, next);
  const Annotation* own = next.find(problem.annotation);
  switch (fix) {
    case ProblemFix::FillFromLeft:
      if (!sides.left) return Error{"there is nothing before this gap", "label"};
      return next.place(sides.left->id, sides.left->start_s, problem.end_s, Conflict::Refuse, range);
    case ProblemFix::FillFromRight:
      if (!sides.right) return Error{"there is nothing after this gap", "label"};
      return next.place(sides.right->id, problem.start_s, sides.right->end_s, Conflict::Refuse, range);
    case ProblemFix::AddToVocabulary:
      return add_value(next, problem);
    case ProblemFix::Remove:
      return next.remove(problem.annotation);
    case ProblemFix::KeepInRange:
      if (!own) break;
      if (own->end_s <= range.first_s || own->start_s >= range.last_s) return next.remove(own->id);
      return next.place(own->id, std::max(own->start_s, range.first_s), std::min(own->end_s, range.last_s),
                        Conflict::Replace, range);
    case ProblemFix::ToFrames:
      if (!own || fps <= 0) break;
      return next.place(own->id, std::round(own->start_s * fps) / fps,
                        std::max(std::round(own->start_s * fps) + 1, std::round(own->end_s * fps)) / fps,
                        Conflict::Replace, range);
  }
  return Error{"no longer exists", "label"};
}

}  // namespace

std::string words_of(ProblemFix fix) {
  switch (fix) {
    case ProblemFix::FillFromLeft:
      return "fill from the left";
    case ProblemFix::FillFromRight:
      return "fill from the right";
    case ProblemFix::Remove:
      return "remove it";
    case ProblemFix::KeepInRange:
      return "cut off the part beyond";
    case ProblemFix::ToFrames:
      return "move to the frames";
    case ProblemFix::AddToVocabulary:
      break;
  }
  return "add to the vocabulary";
}

std::vector<ProblemFix> fixes_of(const AnnotationProblem& problem, const Annotations& annotations) {
  switch (problem.kind) {
    case Kind::Gap: {
      const Sides sides = sides_of(problem, annotations);
      std::vector<ProblemFix> fixes;
      if (sides.left) fixes.push_back(ProblemFix::FillFromLeft);
      if (sides.right) fixes.push_back(ProblemFix::FillFromRight);
      return fixes;
    }
    case Kind::UnknownValue: {
      const AnnotationTier* tier = annotations.tier(problem.tier);
      const Annotation* said = annotations.find(problem.annotation);
      const bool can_say = tier && said && !said->value.empty() && tier->kind != TierKind::Role;
      return can_say ? std::vector{ProblemFix::AddToVocabulary, ProblemFix::Remove}
                     : std::vector{ProblemFix::Remove};
    }
    case Kind::TooShort:
      return {ProblemFix::Remove};
    case Kind::OutOfRange:
      return {ProblemFix::KeepInRange, ProblemFix::Remove};
    case Kind::OffFrame:
      return {ProblemFix::ToFrames};
    case Kind::EmptyTier:
      break;
  }
  return {};
}

Result<Annotations> fixed(const Annotations& annotations, const AnnotationProblem& problem, ProblemFix fix,
                          const Annotations::Range& range, double fps) {
  Annotations next = annotations;
  const Status done = apply(next, problem, fix, range, fps);
  if (!done) return done.error();
  return next;
}

}  // namespace abrazo::widgets
