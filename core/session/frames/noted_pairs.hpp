#pragma once

#include <string>
#include <unordered_map>

namespace abrazo {

/// The recorded frame of a pair, as a session file notes it for each pair that was a candidate.
struct NotedPair {
  std::string take;
  int frame = 0;         ///< of the take's own file
  bool swapped = false;  ///< performer B is the active one
  std::string label;     ///< empty if it has none
};

/// Of a library that is not at hand, by its numbers.
using NotedPairs = std::unordered_map<int, NotedPair>;

}  // namespace abrazo
