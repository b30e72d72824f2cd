#include "core/annotation/label_order.hpp"

#include <cmath>

namespace abrazo {

namespace {

/// Counts of what follows what; the last two of the labels are the beginning and the end of a take.
class Counts {
 public:
  explicit Counts(const LabelledMoves& moves)
      : n_(moves.labels.size()), pairs_((n_ + 2) * (n_ + 2), 0), times_(n_ + 2, 0) {
    for (const LabelledTake& take : moves.takes) {
      std::size_t before = n_;
      for (std::size_t m = 0; m < take.moves.size(); ++m) {
        const auto label = static_cast<std::size_t>(take.moves[m].label);
        note(before, label);
        before = label;
        if (m > 0 && take.moves[m].active >= 0 && take.moves[m - 1].active >= 0)
          ++(take.moves[m].active == take.moves[m - 1].active ? role_stays_ : role_changes_);
      }
      note(before, n_ + 1);
    }
  }

  double log_share(std::size_t from, std::size_t to) const {
    double row = 0, all = 0;
    for (std::size_t l = 0; l < n_ + 2; ++l) row += pairs_[from * (n_ + 2) + l], all += times_[l];
    const auto labels = static_cast<double>(n_);
    const double usual = (times_[to] + 0.5) / (all + 0.5 * (labels + 1));
    return std::log((pairs_[from * (n_ + 2) + to] + labels * usual) / (row + labels));
  }
  double log_role_share(bool stays) const {
    return std::log((stays ? role_stays_ : role_changes_) / (role_stays_ + role_changes_));
  }

 private:
  void note(std::size_t from, std::size_t to) {
    ++pairs_[from * (n_ + 2) + to];
    ++times_[to];
  }
  std::size_t n_;
  std::vector<double> pairs_, times_;
  double role_stays_ = 1, role_changes_ = 1;
};

}  // namespace

LabelOrder label_order(const LabelledMoves& moves, int roles) {
  const Counts counts(moves);
  const std::size_t labels = moves.labels.size(), r = static_cast<std::size_t>(roles), states = labels * r;
  LabelOrder order;
  order.states = static_cast<int>(states);
  for (std::size_t s = 0; s < states; ++s) {
    order.first.push_back(counts.log_share(labels, s / r));
    order.last.push_back(counts.log_share(s / r, labels + 1));
    for (std::size_t next = 0; next < states; ++next)
      order.follows.push_back(counts.log_share(s / r, next / r) +
                              (r == 1 ? 0 : counts.log_role_share(s % r == next % r)));
  }
  return order;
}

}  // namespace abrazo
