#include "core/bodies/foot_steps.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/statistics.hpp"

namespace abrazo {

namespace {

constexpr double standing_below_m = 0.035;
constexpr double standing_speed = 0.5;  ///< [m/s]
constexpr double shortest_run_s = 1.0 / 15;

/// Gives runs of `value` that are shorter than `least`, and not at an end, the other value.
void remove_short_runs(std::vector<char>& flags, char value, std::size_t least) {
  for (std::size_t begin = 0; begin < flags.size();) {
    std::size_t end = begin;
    while (end < flags.size() && flags[end] == flags[begin]) ++end;
    if (flags[begin] == value && begin > 0 && end < flags.size() && end - begin < least)
      std::fill(flags.begin() + static_cast<std::ptrdiff_t>(begin),
                flags.begin() + static_cast<std::ptrdiff_t>(end), static_cast<char>(!value));
    begin = end;
  }
}

}  // namespace

std::vector<char> standing_frames(std::span<const Vec3> toe_base, double fps) {
  std::vector<double> heights;
  for (const Vec3& at : toe_base) heights.push_back(at.y());
  const double rest = percentile(heights, 0.05);
  std::vector<char> standing(toe_base.size());
  for (std::size_t f = 0; f < toe_base.size(); ++f) {
    const std::size_t before = f > 0 ? f - 1 : f, after = std::min(f + 1, toe_base.size() - 1);
    const double elapsed_s = static_cast<double>(after - before) / fps;
    const double speed =
        elapsed_s > 0 ? along_floor(toe_base[after] - toe_base[before]).norm() / elapsed_s : 0;
    standing[f] = heights[f] < rest + standing_below_m && speed < standing_speed;
  }
  const auto least = static_cast<std::size_t>(std::ceil(shortest_run_s * fps - 1e-9));
  remove_short_runs(standing, 0, least);
  remove_short_runs(standing, 1, least);
  return standing;
}

std::vector<Vec3> stepwise(std::span<const Vec3> wanted, std::span<const char> standing) {
  struct Stand {
    std::size_t first, last;
    Vec3 offset;
  };
  std::vector<Stand> stands;
  for (std::size_t f = 0; f < standing.size(); ++f) {
    if (!standing[f]) continue;
    if (f == 0 || !standing[f - 1]) stands.push_back({f, f, Vec3::Zero()});
    stands.back().last = f;
    stands.back().offset += wanted[f];
  }
  std::vector<Vec3> offsets(wanted.begin(), wanted.end());
  if (stands.empty()) return offsets;
  for (Stand& stand : stands) {
    stand.offset /= static_cast<double>(stand.last - stand.first + 1);
    for (std::size_t f = stand.first; f <= stand.last; ++f) offsets[f] = stand.offset;
  }
  for (std::size_t f = 0; f < stands.front().first; ++f) offsets[f] = stands.front().offset;
  for (std::size_t f = stands.back().last + 1; f < offsets.size(); ++f) offsets[f] = stands.back().offset;
  for (std::size_t n = 1; n < stands.size(); ++n) {
    const Stand &from = stands[n - 1], &to = stands[n];
    for (std::size_t f = from.last + 1; f < to.first; ++f) {
      const double u = static_cast<double>(f - from.last) / static_cast<double>(to.first - from.last);
      offsets[f] = from.offset + u * u * (3 - 2 * u) * (to.offset - from.offset);
    }
  }
  return offsets;
}

}  // namespace abrazo
