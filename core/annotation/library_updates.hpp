#pragma once

#include <map>
#include <memory>
#include <string>

#include "core/annotation/annotated_library.hpp"

namespace abrazo {

/// What was said of takes and is not in the library of the session yet: the newest of each take, until a
/// library that has it is in use.
class LibraryUpdates {
 public:
  using Takes = std::map<std::string, TakeAnnotation>;  ///< by name

  /// What is said of a take, when the library, or what is on its way there, has something else.
  /// @return whether something waits now that did not; an Error when a role is neither a nor b
  Result<bool> put(const MotionLibrary& library, const std::string& take, const Annotations& annotations);
  /// All that waits is under way now, together with what was before and did not arrive.
  const Takes& begin();
  /// What is under way is in the library, or cannot be put there.
  void end() { under_way_.clear(); }
  void forget();
  bool is_idle() const { return waiting_.empty() && under_way_.empty(); }

 private:
  Takes waiting_, under_way_;
};

/// A library with them; takes that it does not have are an Error. See `with_annotation`.
Result<std::shared_ptr<const MotionLibrary>> with_updates(std::shared_ptr<const MotionLibrary> library,
                                                          const LibraryUpdates::Takes& takes);

}  // namespace abrazo
