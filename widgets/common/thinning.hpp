#pragma once

#include <cstddef>

namespace abrazo::widgets {

/// Thinning of the older samples of a series that grows for hours, to bound its memory.
struct Thinning {
  std::size_t older = 0;  ///< number of thinned samples at the beginning
  int level = 0;          ///< number of halvings

  /// Keeps the newest samples; reduces older ones evenly to at most `most_older`.
  /// @param count number of samples
  /// @param halve (first, count): halves these samples and returns the number left
  /// @return whether samples were removed
  template <typename Count, typename Halve>
  bool thin(std::size_t newest, std::size_t most_older, Count count, Halve halve) {
    constexpr std::size_t at_once = 8192;  // moving samples costs the same for one and for many
    bool has_thinned = false;
    while (count() >= older + newest + at_once) {
      std::size_t more = at_once;
      for (int halved = 0; halved < level; ++halved) more = halve(older, more);
      older += more;
      if (older > most_older) {
        older = halve(0, older);
        ++level;
      }
      has_thinned = level > 0;
    }
    return has_thinned;
  }
};

}  // namespace abrazo::widgets
