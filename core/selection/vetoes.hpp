#pragma once

#include <set>
#include <string>

namespace abrazo {

/// Recorded pairs that a person excluded from selection, as one value. Names or numbers that are not in the
/// library have no effect.
struct Vetoes {
  std::set<int> pairs;           ///< in the library
  std::set<std::string> takes;   ///< every pair of a take, by the take's name
  std::set<std::string> labels;  ///< every pair with a label; "" = pairs without a label

  bool empty() const { return pairs.empty() && takes.empty() && labels.empty(); }
  bool operator==(const Vetoes&) const = default;
};

}  // namespace abrazo
