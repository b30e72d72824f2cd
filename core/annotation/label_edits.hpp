#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/annotation/annotations.hpp"

namespace abrazo {

/// Where in the annotations of a subject a person edits: what is chosen of them, and which times there are.
struct EditPlace {
  int tier = 0;      ///< id of the active one; 0 = none
  int selected = 0;  ///< id of an annotation; 0 = none
  Conflict conflict = Conflict::Replace;
  Annotations::Range range = {};                  ///< times that the subject has [s]
  double fps = 0;                                 ///< of its frames; 0 = no fixed rate
  double cursor_s = 0;                            ///< [s] of the subject
  std::optional<Annotations::Range> in_out = {};  ///< the range between in and out, where it is set
};

/// What an edit makes of the annotations of a subject.
struct LabelEdit {
  Annotations next;
  std::string what;                  ///< "split turn": for the menu of undo and for messages
  std::optional<int> selected = {};  ///< id of the annotation that is selected then; nothing = as before
  std::optional<int> tier = {};      ///< id of the tier that is active then; nothing = as before
};

// Every edit below either is done whole, or its Error is a message that says why not. New edges are on frames
// of the subject, where it has a fixed rate.

/// The selected label, else the one of the active tier at the cursor.
Result<Annotation> chosen_label(const Annotations& annotations, const EditPlace& place);
/// What a new label of the active tier covers: from in to out, else from the cursor on for a second, or to
/// where the next label begins.
Result<Annotations::Range> span_at(const Annotations& annotations, const EditPlace& place);
/// A new label with a value that a person typed: a role is a or b, and only a note may say nothing.
Result<LabelEdit> draw_label(const Annotations& annotations, const EditPlace& place, int tier,
                             const Annotations::Range& span, std::string_view value);
/// Another value that a person typed or chose; detail and confidence stay. A role is a or b.
Result<LabelEdit> say_label(const Annotations& annotations, int annotation, std::string_view value);

/// A value over a span, as its key says it.
Result<LabelEdit> label_span(const Annotations& annotations, const EditPlace& place, int tier,
                             const Annotations::Range& span, std::string_view value);
/// What a key says while the cursor stands: the selected label of the tier gets the value; without one the
/// value is said from in to out, else from the frame at the cursor to where the next label of the tier
/// begins, and what is there is cut.
Result<LabelEdit> say_at_cursor(const Annotations& annotations, const EditPlace& place, int tier,
                                std::string_view value);

/// Of the selected label only.
Result<LabelEdit> remove_label(const Annotations& annotations, const EditPlace& place);
/// The nearer edge of the selected label goes to the cursor; without one, the end of the label before it.
Result<LabelEdit> extend_label(const Annotations& annotations, const EditPlace& place);
/// At the cursor; the later part is selected.
Result<LabelEdit> split_label(const Annotations& annotations, const EditPlace& place);
Result<LabelEdit> merge_label(const Annotations& annotations, const EditPlace& place);
enum class LabelEdge { Both, Start, End };
/// @param by_s  later [s]; negative = earlier
Result<LabelEdit> nudge_label(const Annotations& annotations, const EditPlace& place, LabelEdge edge,
                              double by_s);
Result<LabelEdit> copy_label(const Annotations& annotations, const EditPlace& place, int tier);
/// From the frame at the cursor on the other performer leads, to the end of the interval it is in. Where
/// nothing was said of roles yet, A led so far.
Result<LabelEdit> change_role(const Annotations& annotations, const EditPlace& place);

/// The next (by = 1) or previous (by = -1) label of the active tier, from the selected one or the cursor.
Result<Annotation> label_beside(const Annotations& annotations, const EditPlace& place, int by);
/// The next (by = 1) or previous (by = -1) tier; the active one where there is none.
int tier_beside(const Annotations& annotations, int tier, int by);
/// The nearest edge of a label of the active tier after (or before) the cursor [s].
std::optional<double> edge_beside(const Annotations& annotations, const EditPlace& place, bool after);

/// A tier for notes in free text; it is active then.
Result<LabelEdit> new_tier(const Annotations& annotations, std::string_view name);
Result<LabelEdit> rename_tier(const Annotations& annotations, int tier, std::string_view name);
Result<LabelEdit> delete_tier(const Annotations& annotations, int tier);

}  // namespace abrazo
