#include "core/session/frames/trace_frames.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(trace)(fuzz::Bytes bytes) {
  const std::string_view text = fuzz::text_of(bytes);
  (void)fuzz::accepted(abrazo::read_trace_frame(text.substr(0, text.find('\n')), 0, {}, "input.jsonl:2"));
  const fuzz::ScratchFile file("input.jsonl", bytes);
  auto trace = abrazo::TraceFrames::open(file.path(), {});
  if (!fuzz::accepted(trace)) return;
  fuzz::expect(!trace->times_s().empty(), "a trace without frames was accepted");
  for (const double time_s : {trace->times_s().front(), trace->times_s().back()})
    (void)fuzz::accepted(trace->at(time_s));
}
