#include "widgets/common/value_look.hpp"

#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
QColor value_colour(const Palette& palette, const AnnotationTier& tier, std::string_view value) {
  const VocabularyEntry* entry = tier.entry(value);
  if (entry && entry->rgb) return QColor::fromRgb(static_cast<QRgb>(*entry->rgb));
  if (tier.kind == TierKind::Role && value == "a") return palette.active;
  if (tier.kind == TierKind::Role && value == "b") return palette.passive;
  return label_colour(palette, value);
}

QString value_words(const AnnotationTier& tier, std::string_view value) {
  if (tier.kind == TierKind::Role) {
    const VocabularyEntry* entry = tier.entry(value);
    if (entry && !entry->description.empty()) return text(entry->description);
    if (value == "a") return "A leads";
    if (value == "b") return "B leads";
  }
  return text(value).replace('_', ' ');
}

}  // namespace abrazo::widgets
