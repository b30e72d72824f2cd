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

/// What a session file notes of a library that is not at hand.
struct NotedPairs {
  std::string library;  ///< its name
  std::string file;     ///< its place at recording; empty if it was never a file
  std::unordered_map<int, NotedPair> by_number;
};

/// A library that frames were solved with and that is not open.
struct AbsentLibrary {
  std::string name;
  std::string file;  ///< its place at recording; empty if it was never a file

  bool operator==(const AbsentLibrary&) const = default;
};

}  // namespace abrazo
