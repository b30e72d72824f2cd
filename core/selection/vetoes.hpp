#pragma once

#include <set>
#include <string>

namespace abrazo {

/// Recorded pairs that a person does not want to be selected, as one value. A name or number that the library
/// does not have vetoes nothing.
struct Vetoes {
  std::set<int> pairs;           ///< in the library
  std::set<std::string> takes;   ///< every pair of a take, by the take's name
  std::set<std::string> labels;  ///< every pair with a label; "" stands for those without one

  bool empty() const { return pairs.empty() && takes.empty() && labels.empty(); }
  bool operator==(const Vetoes&) const = default;
};

}  // namespace abrazo
