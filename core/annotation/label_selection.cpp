#include "core/annotation/label_selection.hpp"

namespace abrazo {

bool LabelSelection::choose_tier(const Annotations& shown, int tier) {
  if (tier == tier_ || !shown.tier(tier)) return false;
  tier_ = tier;
  if (const AnnotationTier* of = shown.tier_of(selected_); of && of->id != tier) selected_ = 0;
  return true;
}

bool LabelSelection::select(const Annotations& shown, int annotation) {
  const AnnotationTier* of = shown.tier_of(annotation);
  if (annotation == selected_ || (annotation != 0 && !of)) return false;
  selected_ = annotation;
  if (of) tier_ = of->id;
  return true;
}

void LabelSelection::begin(const Annotations& shown) {
  tier_ = selected_ = 0;
  settle(shown);
}

void LabelSelection::settle(const Annotations& shown) {
  if (!shown.find(selected_)) selected_ = 0;
  if (shown.tier(tier_)) return;
  const AnnotationTier* moves = shown.first_of(TierKind::Move);
  tier_ = moves ? moves->id : shown.empty() ? 0 : shown.tiers().front().id;
}

}  // namespace abrazo
