#pragma once

#include <cstddef>

namespace abrazo::widgets {

/// The older samples of a row that grows for hours: fewer than came, so that they do not fill the memory.
struct Thinning {
  std::size_t older = 0;  ///< samples at the beginning that stand apart from the newest
  int level = 0;          ///< so often they were halved

  /// Keeps the newest samples as they are; those before become at most `most_older` and stand evenly.
  /// @param count  how many samples there are
  /// @param halve  (first, count): halves these samples and says how many are left of them
  /// @return whether samples have gone
  template <typename Count, typename Halve>
  bool thin(std::size_t newest, std::size_t most_older, Count count, Halve halve) {
    constexpr std::size_t at_once = 8192;  // moving samples together costs the same for one and for many
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
