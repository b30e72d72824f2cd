#include "core/session/file/decisions_json.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(decisions)(fuzz::Bytes bytes) {
  const auto decisions = abrazo::parse_decisions(fuzz::text_of(bytes), "decisions");
  if (!fuzz::accepted(decisions)) return;
  const std::string written = abrazo::decisions_json(*decisions);
  const auto again = abrazo::parse_decisions(written, "again");
  fuzz::expect(again.ok() && abrazo::decisions_json(*again) == written,
               "decisions do not read back to what they were");
}
