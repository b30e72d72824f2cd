#include "core/annotation/library_updates.hpp"

#include <algorithm>
#include <utility>

namespace abrazo {

namespace {

bool is_same(const TakeAnnotation& a, const TakeAnnotation& b) {
  return a.roles == b.roles && a.labels == b.labels;
}

TakeAnnotation as_in(const LibraryTake& take) {
  return {take.roles, take.labels};
}

}  // namespace

Result<bool> LibraryUpdates::put(const MotionLibrary& library, const std::string& take,
                                 const Annotations& annotations) {
  const int found = library.find_take(take);
  if (found < 0) return false;
  const LibraryTake& known = library.takes()[static_cast<std::size_t>(found)];
  auto said = take_annotation(annotations, known.fps, known.frames);
  if (!said) return said.error();
  const auto waiting = waiting_.find(take), under_way = under_way_.find(take);
  const TakeAnnotation last = waiting != waiting_.end()       ? waiting->second
                              : under_way != under_way_.end() ? under_way->second
                                                              : as_in(known);
  if (is_same(last, *said)) return false;
  waiting_[take] = std::move(*said);
  return true;
}

const TakeAnnotations& LibraryUpdates::begin() {
  waiting_.merge(under_way_);
  under_way_ = std::exchange(waiting_, {});
  return under_way_;
}

void LibraryUpdates::forget() {
  waiting_.clear();
  under_way_.clear();
}

Result<std::shared_ptr<const MotionLibrary>> with_updates(const std::shared_ptr<const MotionLibrary>& base,
                                                          const MotionLibrary& annotated,
                                                          const TakeAnnotations& updates) {
  TakeAnnotations all = updates;
  for (const LibraryTake& take : annotated.takes()) all.try_emplace(take.name, as_in(take));
  std::erase_if(all, [&](const auto& one) {
    const int known = base->find_take(one.first);
    return known >= 0 && is_same(as_in(base->takes()[static_cast<std::size_t>(known)]), one.second);
  });
  if (all.empty()) return base;
  auto next = with_annotations(*base, all);
  if (!next) return next.error();
  return std::make_shared<const MotionLibrary>(std::move(next).value());
}

}  // namespace abrazo
