#include <algorithm>

#include "core/library/takes/manifest.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(labels)(fuzz::Bytes bytes) {
  const std::string_view text = fuzz::text_of(bytes);
  const auto takes = abrazo::takes_in_labels(text);
  (void)fuzz::accepted(abrazo::parse_labels(text, "salsa", "input.csv"));
  for (std::size_t t = 0; t < std::min<std::size_t>(takes.size(), 4); ++t) {
    const auto labels = abrazo::parse_labels(text, takes[t], "input.csv");
    if (!fuzz::accepted(labels)) continue;
    for (std::size_t i = 0; i < labels->size(); ++i)
      fuzz::expect((*labels)[i].start < (*labels)[i].end, "a label without length");
  }
}
