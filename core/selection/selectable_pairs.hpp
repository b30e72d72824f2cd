#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/selection/meant_pairs.hpp"
#include "core/selection/vetoes.hpp"

namespace abrazo {

/// Which pairs of a library may be selected at present: those given, without what a person vetoed, and which
/// of them a person means.
class SelectablePairs {
 public:
  /// @param pairs  the most there can be
  SelectablePairs(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs);

  /// In place of the vetoes before.
  void set_vetoes(const Vetoes& vetoes);
  /// Narrows to these (`left_out`), or has the others told apart (`is_not_meant`), as long as one of them may
  /// be selected; otherwise as if none were meant.
  void set_meant(const std::optional<MeantPairs>& meant);

  const std::vector<int>& pairs() const { return pairs_; }
  /// Given to the constructor, vetoed or not.
  bool is_selectable(int pair) const { return selectable_[static_cast<std::size_t>(pair)]; }
  bool is_vetoed(int pair) const { return vetoed_[static_cast<std::size_t>(pair)]; }
  /// Vetoed, or not what is meant.
  bool is_left_out(int pair) const { return left_out_[static_cast<std::size_t>(pair)]; }
  /// Something else is meant that may be selected.
  bool is_not_meant(int pair) const { return is_narrowed_ && is_left_out(pair) && !is_vetoed(pair); }
  /// Nothing is left because of the vetoes.
  bool all_vetoed() const { return !pairs_.empty() && veto_count_ == pairs_.size(); }

  /// At least one is left out.
  bool leaves_out() const { return leaves_out_; }
  const std::vector<bool>& left_out() const { return left_out_; }

 private:
  void leave_out();

  std::shared_ptr<const MotionLibrary> library_;
  std::vector<int> pairs_;
  std::vector<bool> selectable_;
  std::vector<bool> vetoed_;
  std::size_t veto_count_ = 0;  ///< of those that are selectable
  std::optional<MeantPairs> meant_;
  std::vector<bool> left_out_;
  bool leaves_out_ = false;
  bool is_narrowed_ = false;  ///< by what is meant
};

}  // namespace abrazo
