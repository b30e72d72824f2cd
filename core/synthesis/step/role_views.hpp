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
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// A library as seen by the user of each role (for a passive user the roles are exchanged, pair numbers
/// stay), and the model that the selection `intent` learns from it. Each is built once, on first request, and
/// shared by all solvers of the library. Thread-safe: one thread can prepare it so that another need not
/// wait.
class RoleViews {
 public:
  struct View {
    std::shared_ptr<const MotionLibrary> library;  ///< the user is its first body
    std::shared_ptr<const PoseIndex> index;        ///< over the selectable pairs
  };

  /// @param pairs the selectable pairs
  /// @param memory_left available memory [bytes], queried before a mapped library is copied
  RoleViews(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs,
            std::uint64_t (*memory_left)() = available_memory_bytes);

  /// The views that other solvers use at present, or new ones. Views prepared for a session also serve its
  /// comparisons and re-solving.
  static std::shared_ptr<const RoleViews> shared(std::shared_ptr<const MotionLibrary> library,
                                                 std::vector<int> pairs);

  /// Stops threads started by prepare(); waits for steps that cannot be interrupted.
  ~RoleViews();
  RoleViews(const RoleViews&) = delete;
  RoleViews& operator=(const RoleViews&) = delete;

  /// Builds the view if needed; waits if another thread is building it (about 10 us per pair).
  /// @throws std::runtime_error if the available memory does not hold a mapped library with exchanged roles;
  /// the next call tries again
  const View& of(UserRole role) const { return views_[number(role)].get(); }
  /// Whether `of` would return at once.
  bool is_ready(UserRole role) const { return views_[number(role)].is_ready(); }
  /// Builds it on a separate thread, unless that was done. @see trouble
  void prepare(UserRole role) const { views_[number(role)].prepare(); }
  /// Why prepare() failed; returned once, after which prepare() may be called again.
  std::optional<Error> trouble(UserRole role) const { return told(views_[number(role)].trouble()); }
  /// Whether a view needs so much memory that it should only be built on demand: that of a mapped library
  /// with exchanged roles.
  bool is_costly(UserRole role) const { return role == UserRole::Passive && library_->is_mapped(); }

  /// The model of the selection `intent` for a view; learning takes a second or more. These functions
  /// correspond to the four above.
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
  std::array<MadeOnce<LearnedIntent>, 2> intents_;  ///< declared last: destroyed first
};

}  // namespace abrazo
