#pragma once

#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/session/file/library_reference.hpp"

namespace abrazo {

/// The fingerprints of the libraries of a session. A million pairs take seconds: each library is gone through
/// once, on a thread of its own. Keeps no library. Asked by any thread; its end waits for what has begun.
class LibraryFingerprints {
 public:
  using Compute = std::function<std::string(const MotionLibrary&)>;
  explicit LibraryFingerprints(Compute compute = library_fingerprint) : compute_(std::move(compute)) {}

  /// Returns immediately. Empty for a library whose file was damaged meanwhile: it has no content to be known
  /// by.
  std::shared_future<std::string> of(const std::shared_ptr<const MotionLibrary>& library);

 private:
  using Owner = std::weak_ptr<const MotionLibrary>;

  const Compute compute_;
  std::mutex mutex_;
  std::map<Owner, std::shared_future<std::string>, std::owner_less<Owner>> known_;  ///< guarded by `mutex_`
};

}  // namespace abrazo
