#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "core/library/motion_library.hpp"
#include "core/library/pose_index.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

/// A library as the user of each role sees it: for a passive user the roles are exchanged (pair numbers
/// stay). A view is made once, by whoever first asks for it, and shared by all that solve with the library.
/// Safe to call from any thread: prepare it on one, and another need not wait.
class RoleViews {
 public:
  struct View {
    std::shared_ptr<const MotionLibrary> library;  ///< the user is its first body
    std::shared_ptr<const PoseIndex> index;        ///< over the pairs that may be selected
  };

  /// @param pairs  those that may be selected
  RoleViews(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs);

  /// Made now when nobody did; waits when another thread is at it (some 10 us a pair).
  const View& of(UserRole role) const;
  /// `of` would return at once.
  bool is_ready(UserRole role) const { return ready_[number(role)]; }

  const std::shared_ptr<const MotionLibrary>& library() const { return library_; }
  const std::vector<int>& pairs() const { return pairs_; }

 private:
  static std::size_t number(UserRole role) { return role == UserRole::Passive ? 1 : 0; }
  View made(UserRole role) const;

  std::shared_ptr<const MotionLibrary> library_;
  std::vector<int> pairs_;
  mutable std::array<View, 2> views_;
  mutable std::array<std::once_flag, 2> once_;
  mutable std::array<std::atomic<bool>, 2> ready_{};
};

}  // namespace abrazo
