#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/available_memory.hpp"
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
  /// @param memory_left  bytes, asked before a mapped library is copied
  RoleViews(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs,
            std::uint64_t (*memory_left)() = available_memory_bytes);

  /// Ends what prepare() began; waits for what it cannot interrupt.
  ~RoleViews();
  RoleViews(const RoleViews&) = delete;
  RoleViews& operator=(const RoleViews&) = delete;

  /// Made now when nobody did; waits when another thread is at it (some 10 us a pair).
  /// @throws std::runtime_error when the memory that is left does not hold a mapped library with its roles
  /// exchanged; the next call tries again
  const View& of(UserRole role) const;
  /// `of` would return at once.
  bool is_ready(UserRole role) const { return ready_[number(role)]; }
  /// Has it made on a thread of its own, unless that was done. @see trouble
  void prepare(UserRole role) const;
  /// Why prepare() could not make it; said once, and prepare() may then be asked again.
  std::optional<Error> trouble(UserRole role) const;
  /// A view of this role needs so much memory that it should be made for who asks for it only: of a mapped
  /// library the whole, exchanged.
  bool is_costly(UserRole role) const { return role == UserRole::Passive && library_->is_mapped(); }

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
  std::uint64_t (*memory_left_)();
  mutable std::mutex preparing_;
  mutable std::array<std::optional<Error>, 2> troubles_;  ///< guarded by `preparing_`
  mutable std::array<bool, 2> is_preparing_{};            ///< guarded by `preparing_`
  mutable std::array<std::jthread, 2> workers_;           ///< guarded by `preparing_`; last: joined first
};

}  // namespace abrazo
