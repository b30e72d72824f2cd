#include "core/stream/vmc/osc_packet.hpp"
#include "tests/fuzz/stream_checks.hpp"

namespace fuzz = abrazo::fuzz;

/// OSC packets as such, then as a VMC stream.
ABRAZO_FUZZ_TARGET(vmc)(fuzz::Bytes bytes) {
  fuzz::each_packet(bytes, [](fuzz::Bytes packet, double) {
    const abrazo::OscPacket osc = abrazo::read_osc(packet);
    fuzz::expect(osc.issues.size() <= abrazo::most_osc_issues, "more is said of a packet than anybody reads");
    int depth = 0;
    for (const abrazo::OscElement& element : osc.elements) {
      if (element.kind == abrazo::OscElement::Kind::BundleBegin) ++depth;
      if (element.kind == abrazo::OscElement::Kind::BundleEnd) --depth;
      fuzz::expect(depth >= 0 && depth <= abrazo::deepest_osc_bundle, "a bundle that is not in its place");
    }
    fuzz::expect(depth == 0, "a bundle was not closed");
  });
  fuzz::receive("vmc://0.0.0.0:39539", bytes);
}
