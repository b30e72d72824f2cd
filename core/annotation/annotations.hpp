#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/takes/tier.hpp"

namespace abrazo {

/// An interval that was drawn, typed or accepted. Start inclusive, end exclusive, seconds of its subject:
/// of a session its file's time, of a take frame / fps.
struct Annotation : TierInterval {
  int id = 0;  ///< of its Annotations, never used twice in them

  double duration_s() const { return end_s - start_s; }
  bool operator==(const Annotation&) const = default;
};

/// The label with another value.
inline TierInterval with_value(TierInterval label, std::string_view value) {
  label.value = value;
  return label;
}

struct AnnotationTier {
  int id = 0;
  std::string name;
  TierKind kind = TierKind::Note;
  std::vector<VocabularyEntry> vocabulary;  ///< empty = free text
  std::vector<Annotation> annotations;      ///< ascending, not overlapping

  const VocabularyEntry* entry(std::string_view value) const;
  const VocabularyEntry* entry_of_key(char key) const;
  /// The annotation at a time; null if there is none.
  const Annotation* at(double time_s) const;
  bool operator==(const AnnotationTier&) const = default;
};

/// Treatment of annotations that a new or longer one overlaps.
enum class Conflict {
  Replace,  ///< they are cut; covered ones are removed
  Push,     ///< they move with unchanged length (ELAN's bulldozer mode), within the subject's range
  Refuse    ///< nothing changes; the Error names the overlapped annotations
};

/// A proposal of a program. Becomes an annotation only if a person accepts it.
struct Suggestion {
  int id = 0;
  int tier = 0;  ///< id of its tier
  double start_s = 0, end_s = 0;
  std::string value;
  double confidence = 0;  ///< 0 to 1: share of such suggestions that were right in tests
  std::string reason;     ///< "left hand of A holds right hand of B; 7 of 9 neighbours: turn"

  bool operator==(const Suggestion&) const = default;
};

/// The annotations of one subject (a session or a take): tiers of annotations, and suggestions. A value type:
/// undo steps keep copies. Every edit either succeeds completely or changes nothing and returns an Error.
class Annotations {
 public:
  /// Valid times of annotations; edits beyond are limited to it, and refused if nothing is left.
  struct Range {
    double first_s = 0, last_s = 0;
    bool operator==(const Range&) const = default;
  };
  const std::vector<AnnotationTier>& tiers() const { return tiers_; }
  const std::vector<Suggestion>& suggestions() const { return suggestions_; }
  const AnnotationTier* tier(int id) const;
  const AnnotationTier* tier_named(std::string_view name) const;
  const AnnotationTier* first_of(TierKind kind) const;
  const AnnotationTier* tier_of(int annotation) const;
  const Annotation* find(int annotation) const;
  const Suggestion* find_suggestion(int id) const;
  bool empty() const { return tiers_.empty(); }

  /// Adds a tier; an empty or existing name is refused. @return the tier's id
  Result<int> add_tier(std::string_view name, TierKind kind, std::vector<VocabularyEntry> vocabulary);
  Status rename_tier(int tier, std::string_view name);
  /// Values that are not in the new vocabulary stay; `problems_of` lists them.
  Status set_vocabulary(int tier, std::vector<VocabularyEntry> vocabulary);
  Status remove_tier(int tier);
  Status move_tier(int tier, int position);

  /// @return the new annotation's id
  Result<int> draw(int tier, double from_s, double to_s, std::string_view value, Conflict conflict,
                   const Range& range);
  /// Sets start and end (resize, move, nudge).
  Status place(int annotation, double from_s, double to_s, Conflict conflict, const Range& range);
  /// Sets everything except the times.
  Status say(int annotation, const TierInterval& said);
  /// Splits at a time within it; both parts keep the value. @return the id of the later part
  Result<int> split(int annotation, double at_s);
  /// Merges with the next annotation of its tier, including a gap. The earlier value stays.
  Status merge_with_next(int annotation);
  Status remove(int annotation);
  /// Copies the interval to another tier. @return its id
  Result<int> copy_to(int annotation, int tier, Conflict conflict);

  /// Replaces all suggestions for these tiers.
  void suggest(std::span<const int> tiers, std::vector<Suggestion> suggestions);
  /// Turns a suggestion into an annotation. @return the annotation's id
  Result<int> accept(int suggestion, Conflict conflict, const Range& range);
  Status reject(int suggestion);
  void clear_suggestions();

  /// Restores stored annotations with their ids. The Error names the first inconsistency: an id that is not
  /// unique or not below `next_id`, equal names, annotations that are empty, overlapping or unordered, a
  /// suggestion without a tier.
  static Result<Annotations> restored(std::vector<AnnotationTier> tiers, std::vector<Suggestion> suggestions,
                                      int next_id);
  int next_id() const { return next_id_; }

  bool operator==(const Annotations&) const = default;

 private:
  std::vector<AnnotationTier> tiers_;
  std::vector<Suggestion> suggestions_;
  int next_id_ = 1;  ///< shared by tiers, annotations and suggestions
};

/// Annotations by subject: a take of the library, or the session ("").
using AnnotationBook = std::map<std::string, Annotations>;

/// Conversion of tiers to their exchange form and back, without suggestions.
std::vector<Tier> tiers_of(const Annotations& annotations);
Result<Annotations> annotations_of(std::span<const Tier> tiers);

/// A questionable but permitted state: gaps in role and move tiers, values outside the vocabulary, intervals
/// shorter than a frame or beyond the range, edges between frames.
struct AnnotationProblem {
  enum class Kind { Gap, UnknownValue, TooShort, OutOfRange, OffFrame, EmptyTier };
  Kind kind;
  int tier = 0;
  int annotation = 0;  ///< 0 = between annotations
  double start_s = 0, end_s = 0;
  std::string text;  ///< "moves: nothing between 3.20 s and 4.15 s (frames 192-249)"
};
/// @param fps  of the subject's frames
std::vector<AnnotationProblem> problems_of(const Annotations& annotations, const Annotations::Range& range,
                                           double fps);

/// The time of the nearest frame. @param fps 0 = no fixed rate: the time itself
double on_frame(double time_s, double fps);
/// Moves both ends to frames; a span that is not empty keeps at least one frame.
Annotations::Range on_frames(const Annotations::Range& span, double fps);

/// Snap targets of an edge: frames, the cursor, edges of other annotations and markers. Snaps to the nearest
/// within reach; frames last. @return the time itself if nothing is near
struct SnapTargets {
  double fps = 0;  ///< 0 = no snapping to frames
  std::optional<double> cursor_s = {};
  std::vector<double> others_s = {};
};
double snapped(double time_s, const SnapTargets& targets, double reach_s);

}  // namespace abrazo
