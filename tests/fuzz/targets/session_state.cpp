#include "core/session/file/synthesizer_state_bytes.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(session_state)(fuzz::Bytes bytes) {
  const auto state = abrazo::parse_synthesizer_state(bytes);
  if (!fuzz::accepted(state)) return;
  const auto written = abrazo::synthesizer_state_bytes(*state);
  const auto again = abrazo::parse_synthesizer_state(written);
  fuzz::expect(again.ok() && abrazo::synthesizer_state_bytes(*again) == written,
               "a state does not read back to what it was");
}
