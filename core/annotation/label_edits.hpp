#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/annotation/annotations.hpp"

namespace abrazo {

/// Context of an edit: active tier and selection, and the times of the subject.
struct EditPlace {
  int tier = 0;      ///< id of the active one; 0 = none
  int selected = 0;  ///< id of an annotation; 0 = none
  Conflict conflict = Conflict::Replace;
  Annotations::Range range = {};                  ///< valid times of the subject [s]
  double fps = 0;                                 ///< of its frames; 0 = no fixed rate
  double cursor_s = 0;                            ///< [s] of the subject
  std::optional<Annotations::Range> in_out = {};  ///< the range between in and out, if set
};

/// Result of an edit.
struct LabelEdit {
  Annotations next;
  std::string what;                  ///< "split turn": for the undo menu and messages
  std::optional<int> selected = {};  ///< annotation to select afterwards; none = unchanged
  std::optional<int> tier = {};      ///< tier to activate afterwards; none = unchanged
};

// Every edit below either succeeds completely or returns an Error that says why not. New edges are on frames
// if the subject has a fixed rate.

/// The selected label, else the one of the active tier at the cursor.
Result<Annotation> chosen_label(const Annotations& annotations, const EditPlace& place);
/// Span of a new label of the active tier: from in to out, else one second from the cursor, or up to the next
/// label.
Result<Annotations::Range> span_at(const Annotations& annotations, const EditPlace& place);
/// Draws a label with a typed value: a role is a or b; only a note may be empty.
Result<LabelEdit> draw_label(const Annotations& annotations, const EditPlace& place, int tier,
                             const Annotations::Range& span, std::string_view value);
/// Sets a typed or chosen value; detail and confidence stay. A role is a or b.
Result<LabelEdit> say_label(const Annotations& annotations, int annotation, std::string_view value);

/// Sets a value over a span, as its key does.
Result<LabelEdit> label_span(const Annotations& annotations, const EditPlace& place, int tier,
                             const Annotations::Range& span, std::string_view value);
/// Effect of a key while the cursor is parked: the selected label of the tier gets the value; without a
/// selection the value covers in to out, else from the frame at the cursor to the next label of the tier,
/// cutting existing labels.
Result<LabelEdit> say_at_cursor(const Annotations& annotations, const EditPlace& place, int tier,
                                std::string_view value);

/// Removes the selected label.
Result<LabelEdit> remove_label(const Annotations& annotations, const EditPlace& place);
/// Moves the nearer edge of the selected label to the cursor; without a selection, the end of the label
/// before the cursor.
Result<LabelEdit> extend_label(const Annotations& annotations, const EditPlace& place);
/// Splits at the cursor; the later part is selected.
Result<LabelEdit> split_label(const Annotations& annotations, const EditPlace& place);
Result<LabelEdit> merge_label(const Annotations& annotations, const EditPlace& place);
enum class LabelEdge { Both, Start, End };
/// @param by_s  later [s]; negative = earlier
Result<LabelEdit> nudge_label(const Annotations& annotations, const EditPlace& place, LabelEdge edge,
                              double by_s);
Result<LabelEdit> copy_label(const Annotations& annotations, const EditPlace& place, int tier);
/// Makes the other performer lead from the frame at the cursor to the end of the interval. Without annotated
/// roles, A is assumed to lead before.
Result<LabelEdit> change_role(const Annotations& annotations, const EditPlace& place);

/// The next (by = 1) or previous (by = -1) label of the active tier, from the selected one or the cursor.
Result<Annotation> label_beside(const Annotations& annotations, const EditPlace& place, int by);
/// The next (by = 1) or previous (by = -1) tier; the active one if there is none.
int tier_beside(const Annotations& annotations, int tier, int by);
/// The nearest edge of a label of the active tier after (or before) the cursor [s].
std::optional<double> edge_beside(const Annotations& annotations, const EditPlace& place, bool after);

/// Adds a tier for free-text notes and activates it.
Result<LabelEdit> new_tier(const Annotations& annotations, std::string_view name);
Result<LabelEdit> rename_tier(const Annotations& annotations, int tier, std::string_view name);
Result<LabelEdit> delete_tier(const Annotations& annotations, int tier);

}  // namespace abrazo
