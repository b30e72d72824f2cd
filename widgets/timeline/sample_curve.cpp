#include "widgets/timeline/sample_curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "widgets/common/value_range.hpp"

namespace abrazo::widgets {
namespace {

constexpr SampleCurve::Extent nothing = {std::numeric_limits<float>::max(),
                                         std::numeric_limits<float>::lowest()};

void include(SampleCurve::Extent& extent, const SampleCurve::Extent& more) {
  extent.least = std::min(extent.least, more.least);
  extent.most = std::max(extent.most, more.most);
}

}  // namespace

void SampleCurve::append(double time_s, double value) {
  if (!std::isfinite(value)) return;
  const auto small = static_cast<float>(value);
  if (samples_.size() % block_size == 0) blocks_.push_back(nothing);
  include(blocks_.back(), {small, small});
  samples_.push_back({time_s, small});
}

void SampleCurve::thin_older(std::size_t newest, std::size_t most_older) {
  const bool has_thinned = thinning_.thin(
      newest, most_older, [this] { return samples_.size(); },
      [this](std::size_t first, std::size_t count) { return halve(first, count); });
  if (!has_thinned) return;
  blocks_.clear();
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    if (i % block_size == 0) blocks_.push_back(nothing);
    include(blocks_.back(), {samples_[i].value, samples_[i].value});
  }
}

/// Removes dropped samples too. @return the number left of `count`
std::size_t SampleCurve::halve(std::size_t first, std::size_t count) {
  const auto by_value = [](const Sample& a, const Sample& b) { return a.value < b.value; };
  std::size_t to = first;
  const std::size_t given_up = std::min(begin_, first + count);
  const std::size_t begin = std::max(first, given_up);
  begin_ -= begin - first;
  for (std::size_t from = begin; from < first + count; from += 4) {
    const auto group = samples_.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end = group + static_cast<std::ptrdiff_t>(std::min<std::size_t>(4, first + count - from));
    auto [least, largest] = std::minmax_element(group, end, by_value);
    if (largest->time_s < least->time_s) std::swap(least, largest);
    const Sample former = *least, latter = *largest;
    samples_[to++] = former;
    if (latter.time_s != former.time_s) samples_[to++] = latter;
  }
  samples_.erase(samples_.begin() + static_cast<std::ptrdiff_t>(to),
                 samples_.begin() + static_cast<std::ptrdiff_t>(first + count));
  return to - first;
}

void SampleCurve::drop_before(double time_s) {
  begin_ = position(time_s);
  if (2 * begin_ < samples_.size()) return;
  const auto blocks = static_cast<std::ptrdiff_t>(begin_ / block_size);
  const auto samples = blocks * static_cast<std::ptrdiff_t>(block_size);
  samples_.erase(samples_.begin(), samples_.begin() + samples);
  blocks_.erase(blocks_.begin(), blocks_.begin() + blocks);
  begin_ -= static_cast<std::size_t>(samples);
  thinning_.older -= std::min(thinning_.older, static_cast<std::size_t>(samples));
}

void SampleCurve::clear() {
  *this = {};
}

std::size_t SampleCurve::position(double time_s) const {
  const auto first = samples_.begin() + static_cast<std::ptrdiff_t>(begin_);
  const auto found = std::lower_bound(first, samples_.end(), time_s,
                                      [](const Sample& sample, double t) { return sample.time_s < t; });
  return static_cast<std::size_t>(found - samples_.begin());
}

/// Whole blocks from what they know, the rest sample by sample.
SampleCurve::Extent SampleCurve::extent(std::size_t first, std::size_t last) const {
  Extent extent = nothing;
  for (std::size_t i = first; i < last;) {
    if (i % block_size == 0 && i + block_size <= last) {
      include(extent, blocks_[i / block_size]);
      i += block_size;
    } else {
      include(extent, {samples_[i].value, samples_[i].value});
      ++i;
    }
  }
  return extent;
}

std::vector<SampleCurve::Extent> SampleCurve::columns(double from_s, double to_s, int columns) const {
  std::vector<Extent> extents(static_cast<std::size_t>(std::max(columns, 0)), nothing);
  const double width_s = (to_s - from_s) / std::max(columns, 1);
  std::size_t first = position(from_s);
  for (std::size_t column = 0; column < extents.size() && first < samples_.size(); ++column) {
    const double end_s = from_s + static_cast<double>(column + 1) * width_s;
    if (samples_[first].time_s >= end_s) continue;
    const std::size_t last = position(end_s);
    extents[column] = extent(first, last);
    first = last;
  }
  return extents;
}

void bridge_columns(std::vector<SampleCurve::Extent>& columns,
                    const std::function<bool(std::size_t first, std::size_t end)>& has_gap) {
  std::ptrdiff_t previous = -1;
  const auto at = [&columns](std::ptrdiff_t i) -> SampleCurve::Extent& {
    return columns[static_cast<std::size_t>(i)];
  };
  for (std::ptrdiff_t i = 0; i < std::ssize(columns); ++i) {
    if (is_empty(at(i))) continue;
    const std::ptrdiff_t steps = i - previous;
    if (previous >= 0 && steps > 1 &&
        !has_gap(static_cast<std::size_t>(previous + 1), static_cast<std::size_t>(i))) {
      const auto middle = [](const SampleCurve::Extent& column) { return (column.least + column.most) / 2; };
      const float from = middle(at(previous)), to = middle(at(i));
      for (std::ptrdiff_t k = 1; k < steps; ++k) {
        const float value = from + (to - from) * static_cast<float>(k) / static_cast<float>(steps);
        at(previous + k) = {value, value};
      }
    }
    previous = i;
  }
}

double usual_upper(const std::vector<SampleCurve::Extent>& columns) {
  std::vector<double> values;
  values.reserve(columns.size());
  for (const SampleCurve::Extent& column : columns)
    if (!is_empty(column)) values.push_back(column.most);
  return robust_upper(std::move(values));
}

}  // namespace abrazo::widgets
