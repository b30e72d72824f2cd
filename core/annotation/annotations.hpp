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

struct AnnotationTier {
  int id = 0;
  std::string name;
  TierKind kind = TierKind::Note;
  std::vector<VocabularyEntry> vocabulary;  ///< empty = free text
  std::vector<Annotation> annotations;      ///< ascending, not overlapping

  const VocabularyEntry* entry(std::string_view value) const;
  const VocabularyEntry* entry_of_key(char key) const;
  /// The one that holds a time; null when there is none.
  const Annotation* at(double time_s) const;
  bool operator==(const AnnotationTier&) const = default;
};

/// What happens to annotations that a new or longer one overlaps.
enum class Conflict {
  Replace,  ///< they are cut, and those that are covered go
  Push,     ///< they move on with their lengths (ELAN's bulldozer), within the subject's range
  Refuse    ///< nothing changes, and the error names the overlapped annotations
};

/// Something a program proposes. Becomes an annotation only when a person accepts it.
struct Suggestion {
  int id = 0;
  int tier = 0;  ///< id of the tier it is for
  double start_s = 0, end_s = 0;
  std::string value;
  double confidence = 0;  ///< 0 to 1: share of such suggestions that were right when it was measured
  std::string reason;     ///< "left hand of A holds right hand of B; 7 of 9 neighbours: turn"

  bool operator==(const Suggestion&) const = default;
};

/// What is said of one subject, a session or a take: tiers of annotations, and beside them what is only
/// suggested. A value: what an undo step keeps is a copy. Every edit either is done whole or changes nothing
/// and says why.
class Annotations {
 public:
  /// Times that an annotation may have; edits that go beyond are held at the ends, and refused when nothing
  /// is left of them.
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

  /// Tiers; names are unique, and an empty or taken one is refused. @return the tier's id
  Result<int> add_tier(std::string_view name, TierKind kind, std::vector<VocabularyEntry> vocabulary);
  Status rename_tier(int tier, std::string_view name);
  /// Values that the new vocabulary does not have stay; `problems_of` names them.
  Status set_vocabulary(int tier, std::vector<VocabularyEntry> vocabulary);
  Status remove_tier(int tier);
  Status move_tier(int tier, int position);

  /// @return the new annotation's id
  Result<int> draw(int tier, double from_s, double to_s, std::string_view value, Conflict conflict,
                   const Range& range);
  /// New start and end: a resize, a move, a nudge.
  Status place(int annotation, double from_s, double to_s, Conflict conflict, const Range& range);
  Status say(int annotation, std::string_view value, std::string_view detail, std::string_view confidence);
  /// At a time within it; both parts say the same. @return the id of the later part
  Result<int> split(int annotation, double at_s);
  /// With the next one of its tier; what is between them is filled. The earlier one's value stays.
  Status merge_with_next(int annotation);
  Status remove(int annotation);
  /// The same interval in another tier. @return its id
  Result<int> copy_to(int annotation, int tier, Conflict conflict);

  /// In place of all suggestions for those tiers.
  void suggest(std::span<const int> tiers, std::vector<Suggestion> suggestions);
  /// The suggestion becomes an annotation. @return the annotation's id
  Result<int> accept(int suggestion, Conflict conflict, const Range& range);
  Status reject(int suggestion);
  void clear_suggestions();

  /// As they were kept somewhere, with their ids. The error names the first thing that cannot be: an id that
  /// is there twice or not before `next_id`, names alike, annotations that are empty, overlap or are out of
  /// order, a suggestion for no tier.
  static Result<Annotations> restored(std::vector<AnnotationTier> tiers, std::vector<Suggestion> suggestions,
                                      int next_id);
  int next_id() const { return next_id_; }

  bool operator==(const Annotations&) const = default;

 private:
  std::vector<AnnotationTier> tiers_;
  std::vector<Suggestion> suggestions_;
  int next_id_ = 1;  ///< of tiers, annotations and suggestions alike
};

/// Of each subject by name: a take of the library, or the session ("").
using AnnotationBook = std::map<std::string, Annotations>;

/// Confirmed tiers in their exchange form, and back. Suggestions are not among them.
std::vector<Tier> tiers_of(const Annotations& annotations);
Result<Annotations> annotations_of(std::span<const Tier> tiers);

/// What is odd in annotations that are allowed to stand: gaps in role and move tiers, values that the
/// vocabulary does not have, intervals shorter than a frame or beyond the range, edges off the frames.
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

/// The time of the frame that is nearest. @param fps  0 = no fixed rate: the time itself
double on_frame(double time_s, double fps);
/// Both ends on frames; what has a length keeps at least a frame.
Annotations::Range on_frames(const Annotations::Range& span, double fps);

/// Where an edge may snap: to frames, to the cursor, to edges of other annotations and to markers. The
/// nearest within reach; frames last. @return the time itself when nothing is near
struct SnapTargets {
  double fps = 0;  ///< 0 = not to frames
  std::optional<double> cursor_s = {};
  std::vector<double> others_s = {};
};
double snapped(double time_s, const SnapTargets& targets, double reach_s);

}  // namespace abrazo
