#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/available_memory.hpp"
#include "core/base/made_once.hpp"
#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/library/store/pose_index.hpp"
#include "core/selection/intent_model.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

/// A library as the user of each role sees it: for a passive user the roles are exchanged (pair numbers
/// stay), and what the selection `intent` learns of it. Each is made once, by whoever first asks for it, and
/// shared by all that solve with the library. Safe to call from any thread: prepare it on one, and another
/// need not wait.
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

  /// Those that others solve with at present, or new ones: what is prepared for a session serves its
  /// comparisons and what is solved again.
  static std::shared_ptr<const RoleViews> shared(std::shared_ptr<const MotionLibrary> library,
                                                 std::vector<int> pairs);

  /// Ends what prepare() began; waits for what it cannot interrupt.
  ~RoleViews();
  RoleViews(const RoleViews&) = delete;
  RoleViews& operator=(const RoleViews&) = delete;

  /// Made now when nobody did; waits when another thread is at it (some 10 us a pair).
  /// @throws std::runtime_error when the memory that is left does not hold a mapped library with its roles
  /// exchanged; the next call tries again
  const View& of(UserRole role) const { return views_[number(role)].get(); }
  /// `of` would return at once.
  bool is_ready(UserRole role) const { return views_[number(role)].is_ready(); }
  /// Has it made on a thread of its own, unless that was done. @see trouble
  void prepare(UserRole role) const { views_[number(role)].prepare(); }
  /// Why prepare() could not make it; said once, and prepare() may then be asked again.
  std::optional<Error> trouble(UserRole role) const { return told(views_[number(role)].trouble()); }
  /// A view of this role needs so much memory that it should be made for who asks for it only: of a mapped
  /// library the whole, exchanged.
  bool is_costly(UserRole role) const { return role == UserRole::Passive && library_->is_mapped(); }

  /// What is learned of the view for the selection `intent`; takes a second or more. The same as the four
  /// above.
  const std::shared_ptr<const IntentModel>& intent(UserRole role) const {
    return intents_[number(role)].get();
  }
  bool is_intent_ready(UserRole role) const { return intents_[number(role)].is_ready(); }
  void prepare_intent(UserRole role) const { intents_[number(role)].prepare(); }
  std::optional<Error> intent_trouble(UserRole role) const { return told(intents_[number(role)].trouble()); }

  const std::shared_ptr<const MotionLibrary>& library() const { return library_; }
  const std::vector<int>& pairs() const { return pairs_; }

 private:
  using LearnedIntent = std::shared_ptr<const IntentModel>;

  static std::size_t number(UserRole role) { return role == UserRole::Passive ? 1 : 0; }
  View made(UserRole role) const;
  LearnedIntent learned(UserRole role, const Progress& progress) const;
  std::optional<Error> told(const std::optional<std::string>& trouble) const;

  std::shared_ptr<const MotionLibrary> library_;
  std::vector<int> pairs_;
  std::uint64_t (*memory_left_)();
  std::array<MadeOnce<View>, 2> views_;
  std::array<MadeOnce<LearnedIntent>, 2> intents_;  ///< last: they end first
};

}  // namespace abrazo
