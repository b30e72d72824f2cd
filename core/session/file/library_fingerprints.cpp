#include "core/session/file/library_fingerprints.hpp"

#include <utility>

#include "core/base/thread_urgency.hpp"

namespace abrazo {

std::shared_future<std::string> LibraryFingerprints::of(const std::shared_ptr<const MotionLibrary>& library) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(known_, [](const auto& one) { return one.first.expired(); });
  if (const auto found = known_.find(library); found != known_.end()) return found->second;
  // The result outlives the call, and what the call holds with it.
  auto call = [compute = compute_, held = library]() mutable {
    let_others_go_first();
    const std::shared_ptr<const MotionLibrary> used = std::move(held);
    std::string fingerprint = compute(*used);
    return used->damage() ? std::string() : fingerprint;
  };
  return known_[library] = std::async(std::launch::async, std::move(call)).share();
}

}  // namespace abrazo
