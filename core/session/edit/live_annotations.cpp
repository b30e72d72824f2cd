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
  if (of(subject).empty()) book_[subject] = begun_[subject] = begun_annotations(library, subject);
}

void LiveAnnotations::start(const MotionLibrary& library) {
  book_.erase("");
  if (library_ != library.name()) book_.clear();
  std::erase_if(book_, [&](const auto& entry) { return library.find_take(entry.first) < 0; });
  library_ = library.name();
  ++number_;
  begin("", library);
}

void LiveAnnotations::open(AnnotationBook book, const MotionLibrary& library) {
  book_ = std::move(book);
  begun_.clear();
  ++number_;
  begin("", library);
}

}  // namespace abrazo
