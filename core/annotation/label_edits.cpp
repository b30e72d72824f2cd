#include "core/annotation/label_edits.hpp"

#include <algorithm>
#include <cmath>

#include "core/annotation/annotation_room.hpp"

namespace abrazo {

namespace {

std::string plain(std::string_view value) {
  std::string words(value);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string label_words(const Annotation& annotation) {
  return annotation.value.empty() ? "label" : plain(annotation.value);
}

Error no_label_here() {
  return {"No label is selected, and the active tier has none at the cursor; click one in its lane", ""};
}

Error no_tier_yet() {
  return {"Nothing is open, or it has no tier yet", ""};
}

Status check_role(const AnnotationTier& tier, std::string_view value) {
  if (tier.kind == TierKind::Role && value != "a" && value != "b")
    return Error{"A role is a or b, the performers of the take", ""};
  return Done{};
}

/// Where the next label of a tier begins, at most `to_s`.
double free_until(const AnnotationTier& tier, double from_s, double to_s) {
  for (const Annotation& each : tier.annotations)
    if (each.start_s > from_s + same_time_s) to_s = std::min(to_s, each.start_s);
  return to_s;
}

/// The last label for which `is` is true; null if there is none.
template <typename Is>
const Annotation* last_label(const AnnotationTier& tier, Is is) {
  const auto found = std::find_if(tier.annotations.rbegin(), tier.annotations.rend(), is);
  return found == tier.annotations.rend() ? nullptr : &*found;
}

/// `done` of a copy, as an edit.
template <typename Edit>
Result<LabelEdit> edited(const Annotations& annotations, const std::string& what, Edit edit) {
  LabelEdit made{annotations, what};
  if (const Status done = edit(made); !done) return done.error();
  return made;
}

Status selecting(LabelEdit& edit, const Result<int>& annotation) {
  if (!annotation) return annotation.error();
  edit.selected = *annotation;
  return Done{};
}

Status only_done(const Result<int>& result) {
  return result ? Status(Done{}) : Status(result.error());
}

}  // namespace

Result<Annotation> chosen_label(const Annotations& annotations, const EditPlace& place) {
  if (const Annotation* selected = annotations.find(place.selected)) return *selected;
  const AnnotationTier* tier = annotations.tier(place.tier);
  const Annotation* here = tier ? tier->at(place.cursor_s) : nullptr;
  if (!here) return no_label_here();
  return *here;
}

Result<Annotations::Range> span_at(const Annotations& annotations, const EditPlace& place) {
  const AnnotationTier* tier = annotations.tier(place.tier);
  if (!tier) return no_tier_yet();
  if (place.in_out) return on_frames(*place.in_out, place.fps);
  constexpr double usual_s = 1;
  const double from_s = on_frame(place.cursor_s, place.fps);
  const double to_s = on_frame(std::min(from_s + usual_s, place.range.last_s), place.fps);
  return Annotations::Range{from_s, free_until(*tier, from_s, to_s)};
}

Result<LabelEdit> draw_label(const Annotations& annotations, const EditPlace& place, int tier,
                             const Annotations::Range& span, std::string_view value) {
  const AnnotationTier* of = annotations.tier(tier);
  if (!of) return Error{"The tier no longer exists", ""};
  if (value.empty() && of->kind != TierKind::Note) return Error{"Choose or type its value", ""};
  if (const Status good = check_role(*of, value); !good) return good.error();
  const auto [first_s, last_s] = on_frames(span, place.fps);
  return edited(
      annotations, "draw " + plain(value), [&, first_s = first_s, last_s = last_s](LabelEdit& edit) {
        return selecting(edit, edit.next.draw(tier, first_s, last_s, value, place.conflict, place.range));
      });
}

Result<LabelEdit> say_label(const Annotations& annotations, int annotation, std::string_view value) {
  const Annotation* known = annotations.find(annotation);
  if (!known) return Error{"The label no longer exists", ""};
  if (const Status good = check_role(*annotations.tier_of(annotation), value); !good) return good.error();
  return edited(annotations, "label " + plain(value),
                [&](LabelEdit& edit) { return edit.next.say(annotation, with_value(*known, value)); });
}

Result<LabelEdit> label_span(const Annotations& annotations, const EditPlace& place, int tier,
                             const Annotations::Range& span, std::string_view value) {
  const auto [first_s, last_s] = on_frames(span, place.fps);
  return edited(annotations, "label " + plain(value),
                [&, first_s = first_s, last_s = last_s](LabelEdit& edit) {
                  return only_done(edit.next.draw(tier, first_s, last_s, value, place.conflict, place.range));
                });
}

Result<LabelEdit> say_at_cursor(const Annotations& annotations, const EditPlace& place, int tier,
                                std::string_view value) {
  const AnnotationTier* of_selected = annotations.tier_of(place.selected);
  if (of_selected && of_selected->id == tier) {
    const Annotation& selected = *annotations.find(place.selected);
    return edited(annotations, "label " + plain(value),
                  [&](LabelEdit& edit) { return edit.next.say(selected.id, with_value(selected, value)); });
  }
  if (place.in_out) return label_span(annotations, place, tier, *place.in_out, value);
  const AnnotationTier* of = annotations.tier(tier);
  if (!of) return no_tier_yet();
  const double from_s = on_frame(place.cursor_s, place.fps);
  EditPlace here = place;
  here.conflict = Conflict::Replace;  // it begins here, whatever the present value
  return label_span(annotations, here, tier, {from_s, free_until(*of, from_s, place.range.last_s)}, value);
}

Result<LabelEdit> remove_label(const Annotations& annotations, const EditPlace& place) {
  const Annotation* selected = annotations.find(place.selected);
  if (!selected) return no_label_here();
  return edited(annotations, "delete " + label_words(*selected),
                [&](LabelEdit& edit) { return edit.next.remove(selected->id); });
}

Result<LabelEdit> extend_label(const Annotations& annotations, const EditPlace& place) {
  const double here_s = on_frame(place.cursor_s, place.fps);
  const Annotation* label = annotations.find(place.selected);
  if (const AnnotationTier* tier = annotations.tier(place.tier); !label && tier)
    label = last_label(*tier, [&](const Annotation& each) { return each.start_s < here_s - same_time_s; });
  if (!label) return no_label_here();
  const bool start =
      std::abs(here_s - label->start_s) < std::abs(here_s - label->end_s) && here_s < label->end_s;
  return edited(annotations, "extend " + label_words(*label), [&](LabelEdit& edit) {
    return edit.next.place(label->id, start ? here_s : label->start_s, start ? label->end_s : here_s,
                           place.conflict, place.range);
  });
}

Result<LabelEdit> split_label(const Annotations& annotations, const EditPlace& place) {
  const auto label = chosen_label(annotations, place);
  if (!label) return label.error();
  return edited(annotations, "split " + label_words(*label), [&](LabelEdit& edit) {
    return selecting(edit, edit.next.split(label->id, on_frame(place.cursor_s, place.fps)));
  });
}

Result<LabelEdit> merge_label(const Annotations& annotations, const EditPlace& place) {
  const auto label = chosen_label(annotations, place);
  if (!label) return label.error();
  return edited(annotations, "merge " + label_words(*label),
                [&](LabelEdit& edit) { return edit.next.merge_with_next(label->id); });
}

Result<LabelEdit> nudge_label(const Annotations& annotations, const EditPlace& place, LabelEdge edge,
                              double by_s) {
  const auto label = chosen_label(annotations, place);
  if (!label) return label.error();
  const double start_s = label->start_s + (edge == LabelEdge::End ? 0 : by_s);
  const double end_s = label->end_s + (edge == LabelEdge::Start ? 0 : by_s);
  if (end_s <= start_s + same_time_s) return Error{"a label is at least a frame long", ""};
  return edited(annotations, "nudge " + label_words(*label), [&](LabelEdit& edit) {
    edit.selected = label->id;
    return edit.next.place(label->id, start_s, end_s, place.conflict, place.range);
  });
}

Result<LabelEdit> copy_label(const Annotations& annotations, const EditPlace& place, int tier) {
  const auto label = chosen_label(annotations, place);
  if (!label) return label.error();
  return edited(annotations, "copy " + label_words(*label), [&](LabelEdit& edit) {
    return only_done(edit.next.copy_to(label->id, tier, place.conflict));
  });
}

Result<LabelEdit> change_role(const Annotations& annotations, const EditPlace& place) {
  const AnnotationTier* tier = annotations.first_of(TierKind::Role);
  if (!tier) return Error{"There is no tier that says who leads", ""};
  const double here_s = on_frame(place.cursor_s, place.fps);
  return edited(annotations, "change of role", [&](LabelEdit& edit) {
    const Annotation* now = tier->at(here_s);
    const Annotation* before =
        last_label(*tier, [&](const Annotation& each) { return each.end_s <= here_s + same_time_s; });
    std::string leads = now ? now->value : before ? before->value : "b";
    // The first change: A is assumed to lead before.
    if (tier->annotations.empty() && here_s > place.range.first_s + same_time_s) {
      const auto first =
          edit.next.draw(tier->id, place.range.first_s, here_s, "a", Conflict::Refuse, place.range);
      if (!first) return only_done(first);
      leads = "a";
    }
    const double to_s = now ? now->end_s : free_until(*tier, here_s, place.range.last_s);
    return only_done(
        edit.next.draw(tier->id, here_s, to_s, leads == "a" ? "b" : "a", Conflict::Replace, place.range));
  });
}

Result<Annotation> label_beside(const Annotations& annotations, const EditPlace& place, int by) {
  const AnnotationTier* tier = annotations.tier(place.tier);
  if (!tier || tier->annotations.empty()) return Error{"The active tier has no labels", ""};
  const auto& all = tier->annotations;
  const auto selected =
      std::find_if(all.begin(), all.end(), [&](const Annotation& each) { return each.id == place.selected; });
  const Annotation* there = nullptr;
  if (selected != all.end()) {
    const auto at = selected - all.begin() + by;
    if (at >= 0 && at < std::ssize(all)) there = &all[static_cast<std::size_t>(at)];
  } else if (by < 0) {
    there = last_label(*tier,
                       [&](const Annotation& each) { return each.start_s < place.cursor_s - same_time_s; });
  } else {
    const auto next = std::find_if(all.begin(), all.end(), [&](const Annotation& each) {
      return each.start_s > place.cursor_s + same_time_s;
    });
    if (next != all.end()) there = &*next;
  }
  if (!there)
    return Error{by > 0 ? "That is the last label of its tier" : "That is the first label of its tier", ""};
  return *there;
}

int tier_beside(const Annotations& annotations, int tier, int by) {
  const auto& tiers = annotations.tiers();
  const auto active =
      std::find_if(tiers.begin(), tiers.end(), [&](const AnnotationTier& each) { return each.id == tier; });
  const auto at = active - tiers.begin() + by;
  const bool is_there = active != tiers.end() && at >= 0 && at < std::ssize(tiers);
  return is_there ? tiers[static_cast<std::size_t>(at)].id : tier;
}

std::optional<double> edge_beside(const Annotations& annotations, const EditPlace& place, bool after) {
  const AnnotationTier* tier = annotations.tier(place.tier);
  std::optional<double> nearest;
  if (!tier) return nearest;
  for (const Annotation& each : tier->annotations)
    for (const double edge_s : {each.start_s, each.end_s})
      if (after ? edge_s > place.cursor_s + same_time_s && (!nearest || edge_s < *nearest)
                : edge_s < place.cursor_s - same_time_s && (!nearest || edge_s > *nearest))
        nearest = edge_s;
  return nearest;
}

Result<LabelEdit> new_tier(const Annotations& annotations, std::string_view name) {
  return edited(annotations, "add tier", [&](LabelEdit& edit) {
    const auto added = edit.next.add_tier(name, TierKind::Note, {});
    if (added) edit.tier = *added;
    return only_done(added);
  });
}

Result<LabelEdit> rename_tier(const Annotations& annotations, int tier, std::string_view name) {
  return edited(annotations, "rename tier",
                [&](LabelEdit& edit) { return edit.next.rename_tier(tier, name); });
}

Result<LabelEdit> delete_tier(const Annotations& annotations, int tier) {
  return edited(annotations, "delete tier", [&](LabelEdit& edit) { return edit.next.remove_tier(tier); });
}

}  // namespace abrazo
