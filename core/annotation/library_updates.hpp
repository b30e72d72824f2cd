#pragma once

#include <memory>
#include <string>

#include "core/annotation/annotated_library.hpp"

namespace abrazo {

/// Annotations of takes that are not yet in the session's library: the newest per take, until a library that
/// has them is in use.
class LibraryUpdates {
 public:
  /// Puts the annotations of a take in the queue if they differ from the library and from the pending update.
  /// @return whether the queue changed; an Error if a role is neither a nor b
  Result<bool> put(const MotionLibrary& library, const std::string& take, const Annotations& annotations);
  /// Begins an update with everything in the queue, and with the previous update if it did not finish.
  const TakeAnnotations& begin();
  /// Ends the update: it is in the library, or failed.
  void end() { under_way_.clear(); }
  void forget();
  bool is_idle() const { return waiting_.empty() && under_way_.empty(); }

 private:
  TakeAnnotations waiting_, under_way_;
};

/// What `annotated` becomes with the updates. It is made of `base`, the library before all annotations, so
/// that the same annotations make the same library to the bit, in whatever order they came; `base` itself
/// where nothing differs from it. An unknown take is an Error. See `with_annotations`.
Result<std::shared_ptr<const MotionLibrary>> with_updates(const std::shared_ptr<const MotionLibrary>& base,
                                                          const MotionLibrary& annotated,
                                                          const TakeAnnotations& updates);

}  // namespace abrazo
