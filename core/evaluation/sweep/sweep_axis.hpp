#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"

namespace abrazo {

/// One side of a grid: a setting and the values it takes.
struct SweepAxis {
  std::string key;                  ///< of the setting
  std::vector<std::string> values;  ///< as `set_setting` takes them, in the order given; all different

  bool operator==(const SweepAxis&) const = default;
};

/// Reads
///   "alpha=0:1:5"                     5 equally spaced values from 0 to 1, both included
///   "velocity-weight=log:0.01:1:5"    with equal ratios, to 4 digits
///   "edge-weights=inverse,uniform"    the values themselves
/// Values of whole-number settings are rounded. An Error says what is out of range, or that rounding made two
/// values equal.
Result<SweepAxis> parse_sweep_axis(std::string_view text);

}  // namespace abrazo
