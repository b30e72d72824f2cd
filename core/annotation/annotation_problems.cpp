#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/annotation/annotation_room.hpp"
#include "core/annotation/annotations.hpp"

namespace abrazo {

namespace {

using Problem = AnnotationProblem;

/// What is odd in one tier.
class TierCheck {
 public:
  TierCheck(const AnnotationTier& tier, const Annotations::Range& range, double fps)
      : tier_(tier), range_(range), fps_(fps) {}
  std::vector<Problem> problems();

 private:
  bool tiles() const { return tier_.kind != TierKind::Note; }
  void check_gap(double from_s, double to_s);
  void check(const Annotation& annotation);
  void check_value(const Annotation& annotation);
  void add(Problem::Kind kind, const Annotation& annotation, const std::string& text);
  std::string frames_text(double from_s, double to_s) const;
  double frames_off(double time_s) const { return std::abs(time_s * fps_ - std::round(time_s * fps_)); }

  const AnnotationTier& tier_;
  const Annotations::Range& range_;
  double fps_;
  std::vector<Problem> problems_;
};

std::string TierCheck::frames_text(double from_s, double to_s) const {
  if (!(fps_ > 0)) return "";
  return fmt::format(" (frames {:.0f}-{:.0f})", std::round(from_s * fps_), std::round(to_s * fps_));
}

void TierCheck::add(Problem::Kind kind, const Annotation& annotation, const std::string& text) {
  problems_.push_back({kind, tier_.id, annotation.id, annotation.start_s, annotation.end_s,
                       fmt::format("{}: {} {}", tier_.name, spoken(annotation), text)});
}

void TierCheck::check_gap(double from_s, double to_s) {
  const double least_s = fps_ > 0 ? 0.5 / fps_ : same_time_s;
  if (!tiles() || to_s - from_s <= least_s) return;
  problems_.push_back({Problem::Kind::Gap, tier_.id, 0, from_s, to_s,
                       fmt::format("{}: nothing between {:.2f} s and {:.2f} s{}", tier_.name, from_s, to_s,
                                   frames_text(from_s, to_s))});
}

void TierCheck::check_value(const Annotation& annotation) {
  const std::string& value = annotation.value;
  if (value.empty() && (tiles() || !tier_.vocabulary.empty()))
    add(Problem::Kind::UnknownValue, annotation, "says nothing; give it a value");
  else if (tier_.kind == TierKind::Role && value != "a" && value != "b")
    add(Problem::Kind::UnknownValue, annotation, "is not a role; use a or b, the performers of the take");
  else if (!tier_.vocabulary.empty() && !tier_.entry(value))
    add(Problem::Kind::UnknownValue, annotation, "is not in the vocabulary; add it, or say another value");
}

void TierCheck::check(const Annotation& annotation) {
  check_value(annotation);
  if (annotation.start_s < range_.first_s - same_time_s || annotation.end_s > range_.last_s + same_time_s)
    add(Problem::Kind::OutOfRange, annotation,
        fmt::format("is not within {:.3f}-{:.3f} s", range_.first_s, range_.last_s));
  if (!(fps_ > 0)) return;
  if (annotation.duration_s() * fps_ < 1 - 1e-6)
    add(Problem::Kind::TooShort, annotation, fmt::format("is shorter than a frame ({:.4f} s)", 1 / fps_));
  // Files of whole milliseconds are half of one off at most; that is still meant to be the frame.
  const double allowed = std::min(0.00051 * fps_, 0.25);
  if (frames_off(annotation.start_s) > allowed || frames_off(annotation.end_s) > allowed)
    add(Problem::Kind::OffFrame, annotation,
        fmt::format("does not begin and end on frames ({:.2f}, {:.2f})", annotation.start_s * fps_,
                    annotation.end_s * fps_));
}

std::vector<Problem> TierCheck::problems() {
  if (tier_.annotations.empty()) {
    if (tiles())
      problems_.push_back({Problem::Kind::EmptyTier, tier_.id, 0, range_.first_s, range_.last_s,
                           tier_.name + ": nothing is annotated"});
    return std::move(problems_);
  }
  double end_s = range_.first_s;
  for (const Annotation& annotation : tier_.annotations) {
    check_gap(end_s, std::min(annotation.start_s, range_.last_s));
    check(annotation);
    end_s = std::max(end_s, annotation.end_s);
  }
  check_gap(end_s, range_.last_s);
  return std::move(problems_);
}

}  // namespace

std::vector<AnnotationProblem> problems_of(const Annotations& annotations, const Annotations::Range& range,
                                           double fps) {
  std::vector<AnnotationProblem> problems;
  for (const AnnotationTier& tier : annotations.tiers())
    for (AnnotationProblem& problem : TierCheck(tier, range, fps).problems())
      problems.push_back(std::move(problem));
  return problems;
}

double on_frame(double time_s, double fps) {
  return fps > 0 ? std::round(time_s * fps) / fps : time_s;
}

Annotations::Range on_frames(const Annotations::Range& span, double fps) {
  Annotations::Range on{on_frame(span.first_s, fps), on_frame(span.last_s, fps)};
  if (fps > 0 && span.last_s > span.first_s)
    on.last_s = std::max(on.last_s, on_frame(on.first_s + 1 / fps, fps));
  return on;
}

double snapped(double time_s, const SnapTargets& targets, double reach_s) {
  std::optional<double> nearest;
  const auto offer = [&](double target_s) {
    const double distance_s = std::abs(target_s - time_s);
    if (distance_s <= reach_s && (!nearest || distance_s < std::abs(*nearest - time_s))) nearest = target_s;
  };
  if (targets.cursor_s) offer(*targets.cursor_s);
  for (const double other_s : targets.others_s) offer(other_s);
  if (!nearest) offer(on_frame(time_s, targets.fps));
  return nearest.value_or(time_s);
}

}  // namespace abrazo
