#include "tests/fuzz/fuzz_target.hpp"
#include "tests/fuzz/view_json_checks.hpp"

namespace fuzz = abrazo::fuzz;

/// What a session file remembers of panels, markers, camera and scene.
ABRAZO_FUZZ_TARGET(view_json)(fuzz::Bytes bytes) {
  fuzz::expect_view(fuzz::text_of(bytes));
}
