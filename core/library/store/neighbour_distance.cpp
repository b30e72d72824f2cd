#include "core/library/store/neighbour_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace abrazo {

namespace {

constexpr double neighbourhood_s = 1.0;  ///< frames this near in time are alike by nature

bool is_of_the_same_moment(const MotionLibrary& library, int a, int b) {
  const PairSource& first = library.source(a);
  const PairSource& second = library.source(b);
  if (first.take != second.take) return false;
  const double frames = std::abs(static_cast<double>(first.frame) - static_cast<double>(second.frame));
  return frames <= neighbourhood_s * library.takes()[first.take].fps;
}

double distance_to_nearest(const MotionLibrary& library, int pair) {
  double nearest = std::numeric_limits<double>::infinity();
  for (int other = 0; other < library.pair_count(); ++other) {
    const double squared = (library.features(other) - library.features(pair)).squaredNorm();
    if (squared < nearest && !is_of_the_same_moment(library, pair, other)) nearest = squared;
  }
  return std::sqrt(nearest);
}

}  // namespace

std::optional<double> typical_neighbour_distance(const MotionLibrary& library, int samples,
                                                 const Progress& progress) {
  const int pairs = library.pair_count();
  const int stride = std::max(1, pairs / std::max(1, samples));
  std::vector<double> distances;
  for (int pair = stride / 2; pair < pairs; pair += stride) {
    if (!report(progress, static_cast<double>(pair) / pairs, "measuring the library")) return std::nullopt;
    const double distance = distance_to_nearest(library, pair);
    if (std::isfinite(distance)) distances.push_back(distance);
  }
  if (distances.empty()) return std::nullopt;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace abrazo
