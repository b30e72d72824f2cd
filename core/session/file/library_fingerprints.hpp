#pragma once

#include <functional>
#include <future>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/session/file/library_reference.hpp"

namespace abrazo {

/// Fingerprints of the libraries of a session. A million pairs take seconds, so each library is hashed once
/// on its own thread. Does not keep libraries alive. Thread-safe; the destructor waits for running threads.
class LibraryFingerprints {
 public:
  using Compute = std::function<std::string(const MotionLibrary&)>;
  explicit LibraryFingerprints(Compute compute = library_fingerprint) : compute_(std::move(compute)) {}

  /// Returns immediately. The fingerprint is empty if the library's file was damaged meanwhile.
  std::shared_future<std::string> of(const std::shared_ptr<const MotionLibrary>& library);

 private:
  using Owner = std::weak_ptr<const MotionLibrary>;

  const Compute compute_;
  std::mutex mutex_;
  std::map<Owner, std::shared_future<std::string>, std::owner_less<Owner>> known_;  ///< guarded by `mutex_`
};

}  // namespace abrazo
