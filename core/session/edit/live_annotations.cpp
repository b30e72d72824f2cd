#include "core/session/edit/live_annotations.hpp"

#include <algorithm>
#include <utility>

#include "core/annotation/annotated_library.hpp"

namespace abrazo {

namespace {

void give_keys(Annotations& annotations) {
  for (const AnnotationTier& tier : std::vector<AnnotationTier>(annotations.tiers())) {
    auto vocabulary = tier.vocabulary;
    const bool has_keys = std::any_of(vocabulary.begin(), vocabulary.end(),
                                      [](const VocabularyEntry& entry) { return entry.key != 0; });
    if (has_keys || tier.kind == TierKind::Note) continue;
    char digit = '1';
    for (VocabularyEntry& entry : vocabulary) {
      const bool is_role = tier.kind == TierKind::Role && entry.value.size() == 1;
      entry.key = is_role ? entry.value.front() : digit <= '9' ? digit++ : '\0';
    }
    (void)annotations.set_vocabulary(tier.id, std::move(vocabulary));
  }
}

/// The tiers and vocabularies of takes, without annotations.
Annotations without_labels(const Annotations& of_take) {
  Annotations annotations;
  for (const AnnotationTier& tier : of_take.tiers()) {
    auto vocabulary = tier.vocabulary;
    if (tier.kind == TierKind::Role) vocabulary = {{"a", "user leads"}, {"b", "partner leads"}};
    (void)annotations.add_tier(tier.name, tier.kind, std::move(vocabulary));
  }
  return annotations;
}

/// Adds the values that the same kind of tier has in another subject. They get no new keys: which of them
/// were there first is in no file.
void take_words(const Annotations& from, Annotations& annotations) {
  const std::vector<Tier> tiers = tiers_of(from);
  for (const AnnotationTier& tier : std::vector<AnnotationTier>(annotations.tiers())) {
    const auto same = std::ranges::find(tiers, tier.kind, &Tier::kind);
    if (tier.kind == TierKind::Note || same == tiers.end()) continue;
    (void)annotations.set_vocabulary(tier.id, with_values_of(tier.vocabulary, *same));
  }
}

}  // namespace

Annotations begun_annotations(const MotionLibrary& library, const std::string& subject) {
  if (library.takes().empty()) return {};
  Annotations annotations = library.find_take(subject) >= 0
                                ? annotations_of_take(library, subject)
                                : without_labels(annotations_of_take(library, library.takes().front().name));
  (void)annotations.add_tier("note", TierKind::Note, {});
  give_keys(annotations);
  return annotations;
}

const Annotations& LiveAnnotations::of(const std::string& subject) const {
  static const Annotations nothing;
  const auto found = book_.find(subject);
  return found == book_.end() ? nothing : found->second;
}

AnnotationBook LiveAnnotations::changed() const {
  AnnotationBook changed;
  for (const auto& [subject, annotations] : book_) {
    const auto known = begun_.find(subject);
    if (known == begun_.end() || known->second != annotations) changed[subject] = annotations;
  }
  return changed;
}

void LiveAnnotations::begin(const std::string& subject, const MotionLibrary& library) {
  if (!of(subject).empty()) return;
  Annotations begun = begun_annotations(library, subject);
  for (const auto& [other, annotations] : changed()) take_words(annotations, begun);
  book_[subject] = begun_[subject] = std::move(begun);
}

void LiveAnnotations::start(const MotionLibrary& library) {
  saved_.erase("");
  if (library_ != library.name()) saved_.clear();
  std::erase_if(saved_, [&](const auto& entry) { return library.find_take(entry.first) < 0; });
  book_ = saved_;
  library_ = library.name();
  ++number_;
  begin("", library);
}

void LiveAnnotations::open(AnnotationBook book, const MotionLibrary& library, bool is_saved) {
  book_ = std::move(book);
  saved_ = is_saved ? book_ : AnnotationBook();
  begun_.clear();
  ++number_;
  begin("", library);
}

}  // namespace abrazo
