#include "core/selection/selectable_pairs.hpp"

#include <string>
#include <string_view>

namespace abrazo {

namespace {

std::vector<bool> as_flags(const std::vector<int>& pairs, int count) {
  std::vector<bool> flags(static_cast<std::size_t>(count), false);
  for (const int pair : pairs) flags[static_cast<std::size_t>(pair)] = true;
  return flags;
}

/// Called for successive pairs: pairs of a take and of a move are adjacent, so the result for the previous
/// pair mostly holds for the next.
class VetoTest {
 public:
  VetoTest(const Vetoes& vetoes, const MotionLibrary& library) : vetoes_(vetoes), library_(library) {
    for (const LibraryTake& take : library.takes()) takes_.push_back(vetoes.takes.contains(take.name));
  }

  bool operator()(int pair) {
    return takes_[library_.source(pair).take] || vetoes_.pairs.contains(pair) || has_vetoed_label(pair);
  }

 private:
  bool has_vetoed_label(int pair) {
    if (vetoes_.labels.empty()) return false;
    const std::string_view label = library_.label(pair);
    if (label != last_label_ || !asked_) last_answer_ = vetoes_.labels.contains(std::string(label));
    asked_ = true;
    last_label_ = label;
    return last_answer_;
  }

  const Vetoes& vetoes_;
  const MotionLibrary& library_;
  std::vector<bool> takes_;
  std::string_view last_label_;
  bool asked_ = false, last_answer_ = false;
};

}  // namespace

SelectablePairs::SelectablePairs(std::shared_ptr<const MotionLibrary> library, std::vector<int> pairs)
    : library_(std::move(library)),
      pairs_(std::move(pairs)),
      selectable_(as_flags(pairs_, library_->pair_count())),
      vetoed_(selectable_.size(), false),
      left_out_(vetoed_) {}

void SelectablePairs::set_vetoes(const Vetoes& vetoes) {
  VetoTest is_unwanted(vetoes, *library_);
  veto_count_ = 0;
  for (const int pair : pairs_) {
    const bool unwanted = is_unwanted(pair);
    vetoed_[static_cast<std::size_t>(pair)] = unwanted;
    if (unwanted) ++veto_count_;
  }
  leave_out();
}

void SelectablePairs::set_intended(const std::optional<IntendedPairs>& meant) {
  meant_ = meant;
  leave_out();
}

void SelectablePairs::leave_out() {
  left_out_ = vetoed_;
  leaves_out_ = veto_count_ > 0;
  is_narrowed_ = false;
  if (!meant_ || all_vetoed()) return;
  const int take = meant_->take ? library_->find_take(*meant_->take) : -1;
  const auto is_meant = [&](int pair) {
    return (!meant_->take || static_cast<int>(library_->source(pair).take) == take) &&
           (!meant_->label || library_->label(pair) == *meant_->label);
  };
  bool leaves_any = false;
  for (const int pair : pairs_) {
    const auto at = static_cast<std::size_t>(pair);
    left_out_[at] = vetoed_[at] || !is_meant(pair);
    leaves_any = leaves_any || !left_out_[at];
  }
  leaves_out_ = leaves_any || veto_count_ > 0;
  is_narrowed_ = leaves_any;
  if (!leaves_any) left_out_ = vetoed_;
}

}  // namespace abrazo
