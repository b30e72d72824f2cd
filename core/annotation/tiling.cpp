#include "core/annotation/tiling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace abrazo {

namespace {

constexpr double never = -std::numeric_limits<double>::infinity();

/// log(exp(a) + exp(b)).
double log_sum(double a, double b) {
  if (a < b) std::swap(a, b);
  return b == never ? a : a + std::log1p(std::exp(b - a));
}

/// Tables of cuts x states.
class CutTable {
 public:
  CutTable(const TilingScores& scores, double value)
      : states_(static_cast<std::size_t>(scores.states())),
        values_((static_cast<std::size_t>(scores.cells()) + 1) * states_, value) {}
  double& at(int cut, int state) {
    return values_[static_cast<std::size_t>(cut) * states_ + static_cast<std::size_t>(state)];
  }

 private:
  std::size_t states_;
  std::vector<double> values_;
};

int longest_before(const TilingScores& scores, int cut) {
  return std::min(scores.longest(), cut);
}

/// log of the sum over the tilings of [0, cut) that continue with a segment in the state.
void sum_before(const TilingScores& scores, double temperature, CutTable& entered) {
  std::vector<double> ended(static_cast<std::size_t>(scores.states()));  // in the state, at this cut
  for (int cut = 0; cut <= scores.cells(); ++cut)
    if (cut == 0) {
      for (int state = 0; state < scores.states(); ++state)
        entered.at(0, state) = scores.first[static_cast<std::size_t>(state)] / temperature;
    } else {
      for (int state = 0; state < scores.states(); ++state) {
        double& sum = ended[static_cast<std::size_t>(state)] = never;
        for (int length = 1; length <= longest_before(scores, cut); ++length)
          sum = log_sum(sum, entered.at(cut - length, state) +
                                 scores.segment(cut - length, length, state) / temperature);
      }
      for (int next = 0; next < scores.states(); ++next)
        for (int before = 0; before < scores.states(); ++before)
          entered.at(cut, next) =
              log_sum(entered.at(cut, next),
                      ended[static_cast<std::size_t>(before)] + scores.follows(before, next) / temperature);
    }
}

/// log of the sum over the tilings of [cut, end) after a segment in the state. @return that of all tilings
double sum_after(const TilingScores& scores, double temperature, CutTable& to_come) {
  std::vector<double> open(static_cast<std::size_t>(scores.states()));  // a segment in the state begins here
  for (int cut = scores.cells(); cut >= 0; --cut) {
    for (int state = 0; state < scores.states(); ++state) {
      double& sum = open[static_cast<std::size_t>(state)] = never;
      for (int length = 1; length <= std::min(scores.longest(), scores.cells() - cut); ++length)
        sum =
            log_sum(sum, scores.segment(cut, length, state) / temperature + to_come.at(cut + length, state));
    }
    for (int state = 0; state < scores.states(); ++state)
      if (cut == scores.cells())
        to_come.at(cut, state) = scores.last[static_cast<std::size_t>(state)] / temperature;
      else
        for (int next = 0; next < scores.states(); ++next)
          to_come.at(cut, state) = log_sum(to_come.at(cut, state), scores.follows(state, next) / temperature +
                                                                       open[static_cast<std::size_t>(next)]);
  }
  double all = never;
  for (int state = 0; state < scores.states(); ++state)
    all = log_sum(all, scores.first[static_cast<std::size_t>(state)] / temperature +
                           open[static_cast<std::size_t>(state)]);
  return all;
}

}  // namespace

TilingScores::TilingScores(int cells, int longest, int states)
    : first(static_cast<std::size_t>(states), 0),
      last(static_cast<std::size_t>(states), 0),
      cells_(cells),
      longest_(std::min(longest, cells)),
      states_(states) {
  if (cells < 1 || longest < 1 || states < 1)
    throw std::invalid_argument("a tiling needs cells, states and lengths of at least 1");
  segments_.assign(static_cast<std::size_t>(cells_) * static_cast<std::size_t>(longest_) *
                       static_cast<std::size_t>(states_),
                   never);
  follows_.assign(static_cast<std::size_t>(states_) * static_cast<std::size_t>(states_), 0);
}

std::vector<TilingSegment> best_tiling(const TilingScores& scores) {
  struct Step {
    int length = 0, before = -1;
  };
  CutTable ended(scores, never);    // best of the tilings of [0, cut) whose last segment is in the state
  CutTable entered(scores, never);  // of the same with a segment in the state to begin at the cut
  const auto states = static_cast<std::size_t>(scores.states());
  std::vector<Step> steps((static_cast<std::size_t>(scores.cells()) + 1) * states);
  std::vector<int> came_from(steps.size(), -1);
  const auto at = [states](int cut, int state) {
    return static_cast<std::size_t>(cut) * states + static_cast<std::size_t>(state);
  };
  for (int cut = 0; cut <= scores.cells(); ++cut) {
    for (int state = 0; state < scores.states(); ++state) {
      for (int length = 1; length <= longest_before(scores, cut); ++length) {
        const double sum = entered.at(cut - length, state) + scores.segment(cut - length, length, state);
        if (!(sum > ended.at(cut, state))) continue;
        ended.at(cut, state) = sum;
        steps[at(cut, state)] = {length, came_from[at(cut - length, state)]};
      }
    }
    for (int state = 0; state < scores.states(); ++state) {
      if (cut == 0) entered.at(cut, state) = scores.first[static_cast<std::size_t>(state)];
      for (int before = 0; cut > 0 && before < scores.states(); ++before) {
        const double sum = ended.at(cut, before) + scores.follows(before, state);
        if (!(sum > entered.at(cut, state))) continue;
        entered.at(cut, state) = sum;
        came_from[at(cut, state)] = before;
      }
    }
  }
  int state = -1;
  double best = never;
  for (int s = 0; s < scores.states(); ++s) {
    const double sum = ended.at(scores.cells(), s) + scores.last[static_cast<std::size_t>(s)];
    if (sum > best) best = sum, state = s;
  }
  std::vector<TilingSegment> tiling;
  for (int cut = scores.cells(); state >= 0 && cut > 0;) {
    const Step step = steps[at(cut, state)];
    tiling.push_back({cut - step.length, cut, state});
    cut -= step.length;
    state = step.before;
  }
  std::reverse(tiling.begin(), tiling.end());
  return tiling;
}

std::vector<double> state_probabilities(const TilingScores& scores, double temperature) {
  if (!(temperature > 0)) throw std::invalid_argument("a temperature is above 0");
  CutTable entered(scores, never), to_come(scores, never);
  sum_before(scores, temperature, entered);
  const double all = sum_after(scores, temperature, to_come);
  const auto states = static_cast<std::size_t>(scores.states());
  // Changes at the cuts; their sums over the cells follow.
  std::vector<double> shares((static_cast<std::size_t>(scores.cells()) + 1) * states, 0);
  if (all == never) return std::vector<double>(shares.size() - states, 1.0 / scores.states());
  const auto at = [&](int cut, int state) -> double& {
    return shares[static_cast<std::size_t>(cut) * states + static_cast<std::size_t>(state)];
  };
  for (int begin = 0; begin < scores.cells(); ++begin)
    for (int length = 1; length <= std::min(scores.longest(), scores.cells() - begin); ++length)
      for (int state = 0; state < scores.states(); ++state) {
        const double share =
            std::exp(entered.at(begin, state) + scores.segment(begin, length, state) / temperature +
                     to_come.at(begin + length, state) - all);
        at(begin, state) += share;
        at(begin + length, state) -= share;
      }
  for (std::size_t i = states; i < shares.size(); ++i) shares[i] += shares[i - states];
  shares.resize(shares.size() - states);
  for (double& share : shares) share = std::clamp(share, 0.0, 1.0);
  return shares;
}

}  // namespace abrazo
