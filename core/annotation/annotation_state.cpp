#include "core/annotation/annotation_state.hpp"

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

const Annotations& AnnotationState::annotations_of(const std::string& subject) const {
  static const Annotations nothing;
  const auto found = book_.find(subject);
  return found == book_.end() ? nothing : found->second;
}

AnnotationBook AnnotationState::changed() const {
  AnnotationBook changed;
  for (const auto& [subject, annotations] : book_) {
    const auto known = begun_.find(subject);
    if (known == begun_.end() || known->second != annotations) changed[subject] = annotations;
  }
  return changed;
}

void AnnotationState::begin_if_new(const std::string& subject, const MotionLibrary& library) {
  if (annotations_of(subject).empty()) book_[subject] = begun_[subject] = begun_annotations(library, subject);
}

void AnnotationState::start(const MotionLibrary& library) {
  book_.erase("");
  if (library_ != library.name()) book_.clear();
  std::erase_if(book_, [&](const auto& entry) { return library.find_take(entry.first) < 0; });
  library_ = library.name();
  ++number_;
  subject_.clear();
  begin_if_new("", library);
  tier_ = 0;
  settle_chosen();
}

void AnnotationState::set_book(AnnotationBook book, const MotionLibrary* library) {
  book_ = std::move(book);
  begun_.clear();
  ++number_;
  if (library) {
    begin_if_new("", *library);
    begin_if_new(subject_, *library);
  }
  settle_chosen();
}

void AnnotationState::show(const std::string& subject, const MotionLibrary& library) {
  subject_ = subject;
  begin_if_new(subject, library);
  tier_ = selected_ = 0;
  settle_chosen();
}

bool AnnotationState::choose_tier(int tier) {
  if (tier == tier_ || !annotations().tier(tier)) return false;
  tier_ = tier;
  if (const AnnotationTier* of = annotations().tier_of(selected_); of && of->id != tier) selected_ = 0;
  return true;
}

bool AnnotationState::select(int annotation) {
  const AnnotationTier* of = annotations().tier_of(annotation);
  if (annotation == selected_ || (annotation != 0 && !of)) return false;
  selected_ = annotation;
  if (of) tier_ = of->id;
  return true;
}

std::optional<AnnotationStep> AnnotationState::step(const std::string& subject, Annotations next,
                                                    std::string what) const {
  const Annotations& before = annotations_of(subject);
  if (next == before) return std::nullopt;
  return AnnotationStep{number_, subject, before, std::move(next), std::move(what)};
}

bool AnnotationState::apply(const AnnotationStep& step, Direction direction) {
  if (step.book != number_) return false;
  book_[step.subject] = direction == Direction::Do ? step.after : step.before;
  settle_chosen();
  return true;
}

/// What is chosen is there.
void AnnotationState::settle_chosen() {
  const Annotations& shown = annotations();
  if (!shown.find(selected_)) selected_ = 0;
  if (shown.tier(tier_)) return;
  const AnnotationTier* moves = shown.first_of(TierKind::Move);
  tier_ = moves ? moves->id : shown.empty() ? 0 : shown.tiers().front().id;
}

}  // namespace abrazo
