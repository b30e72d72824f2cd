#pragma once

#include <memory>
#include <vector>

#include "core/synthesis/settings/settings.hpp"
#include "tests/bench/bench_data.hpp"
#include "tests/bench/kkt_system.hpp"
#include "tests/bench/recording_solver.hpp"

namespace abrazo::bench {

/// What the solver was asked in each frame of a run.
struct RecordedFrames {
  std::vector<FrameCalls> frames;
};

/// The user's first frames at this rate through the real pipeline, with a solver in it that records.
RecordedFrames record_frames(const BenchData& data, const Settings& settings, double rate_hz, int frames);

/// The whole Lagrange system of a step.
KktSystem kkt_of(const PosedSystem& posed);

/// The same frames through the production pipeline, one after another, over and over.
class WholeSteps {
 public:
  WholeSteps(const BenchData& data, const Settings& settings, double rate_hz, int frames);
  ~WholeSteps();
  void next();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace abrazo::bench
