#include "core/annotation/segment_features.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace abrazo {

SegmentFeatures::SegmentFeatures(const MotionChannels& channels) : channels_(channels) {
  sums_.setZero(channels.frames() + 1, channels.count());
  for (int f = 0; f < channels.frames(); ++f)
    sums_.row(f + 1) = sums_.row(f) + channels.values.row(f).cast<double>();
}

void SegmentFeatures::describe(int begin, int end, float* row) const {
  if (begin < 0 || end > channels_.frames() || begin >= end)
    throw std::invalid_argument("a stretch without frames has no features");
  const int n = channels_.count();
  using Values = Eigen::Map<Eigen::Matrix<float, 1, Eigen::Dynamic>>;
  const auto frames = channels_.values.middleRows(begin, end - begin);
  Values(row, n) = ((sums_.row(end) - sums_.row(begin)) / (end - begin)).cast<float>();
  Values(row + n, n) = frames.colwise().minCoeff();
  Values(row + 2 * n, n) = frames.colwise().maxCoeff();
  Values(row + 3 * n, n) = frames.row(0);
  Values(row + 4 * n, n) = frames.row(frames.rows() - 1);
  float* own = row + 5 * n;
  const auto add = [&own](double value) { *own++ = static_cast<float>(value); };
  const TurnCount x = turn_count(channels_.n_x, begin, end), y = turn_count(channels_.n_y, begin, end),
                  orb = turn_count(channels_.orb, begin, end);
  add((end - begin) / channels_.fps);
  for (const TurnCount& turns : {x, y}) {
    add(turns.net);
    add(std::abs(turns.net));
    add(turns.rise);
    add(turns.fall);
    add(turns.drop);
  }
  add(std::max(std::abs(x.net), std::abs(y.net)));
  add(orb.net);
  add(std::abs(orb.net));
}

TurnCount turn_count(const std::vector<double>& turns, int begin, int end) {
  TurnCount count;
  const auto at = [&turns](int frame) { return turns[static_cast<std::size_t>(frame)]; };
  double lowest = at(begin), highest = at(begin), after_rise = at(begin);
  for (int f = begin; f < end; ++f) {
    lowest = std::min(lowest, at(f));
    highest = std::max(highest, at(f));
    if (at(f) - lowest > count.rise) {
      count.rise = at(f) - lowest;
      after_rise = at(f);
      count.fall = 0;
    }
    count.fall = std::max(count.fall, count.rise > 0 ? after_rise - at(f) : 0);
    count.drop = std::max(count.drop, highest - at(f));
  }
  count.net = at(end - 1) - at(begin);
  return count;
}

}  // namespace abrazo
