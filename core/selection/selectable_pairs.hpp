#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/selection/intended_pairs.hpp"
#include "core/selection/vetoes.hpp"

namespace abrazo {

/// The pairs of a library that may be selected at present: the given ones without the vetoed ones, restricted
/// or marked by the intended move.
class SelectablePairs {
 public:
  /// @param pairs all selectable pairs
  SelectablePairs(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs);

  /// Replaces the vetoes.
  void set_vetoes(const Vetoes& vetoes);
  /// Restricts to the pairs of an intended move (`left_out`), or marks the others (`is_not_intended`), as
  /// long as one of them is selectable; otherwise there is no effect.
  void set_intended(const std::optional<IntendedPairs>& meant);

  const std::vector<int>& pairs() const { return pairs_; }
  /// Whether a pair was given to the constructor, vetoed or not.
  bool is_selectable(int pair) const { return selectable_[static_cast<std::size_t>(pair)]; }
  bool is_vetoed(int pair) const { return vetoed_[static_cast<std::size_t>(pair)]; }
  /// Vetoed, or not of the intended move.
  bool is_left_out(int pair) const { return left_out_[static_cast<std::size_t>(pair)]; }
  /// Whether another, selectable move is intended.
  bool is_not_intended(int pair) const { return is_narrowed_ && is_left_out(pair) && !is_vetoed(pair); }
  /// Whether the vetoes leave no pair.
  bool all_vetoed() const { return !pairs_.empty() && veto_count_ == pairs_.size(); }

  /// Whether at least one pair is left out.
  bool leaves_out() const { return leaves_out_; }
  const std::vector<bool>& left_out() const { return left_out_; }

 private:
  void leave_out();

  std::shared_ptr<const MotionLibrary> library_;
  std::vector<int> pairs_;
  std::vector<bool> selectable_;
  std::vector<bool> vetoed_;
  std::size_t veto_count_ = 0;  ///< number of selectable pairs that are vetoed
  std::optional<IntendedPairs> meant_;
  std::vector<bool> left_out_;
  bool leaves_out_ = false;
  bool is_narrowed_ = false;  ///< by the intended move
};

}  // namespace abrazo
