#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/metrics/run_comparison.hpp"
#include "core/session/frames/comparison_plan.hpp"
#include "core/session/frames/frame_history.hpp"
#include "core/session/run/re_solver.hpp"

namespace abrazo {

/// Results of a comparison task so far.
struct Comparison {
  ComparisonTask task;
  /// Frames of both runs at the same indices, without meshes and morph steps. Still growing while not done.
  std::shared_ptr<const FrameHistory> a, b;
  RunFigures figures_a{}, figures_b{};  ///< over `steps`
  std::vector<ComparedStep> steps;
  Settings settings_a, settings_b;  ///< at the last step
  bool done = false;
  bool is_short = false;     ///< begins later than requested: older inputs are no longer kept
  std::uint64_t unread = 0;  ///< frames of the range that cannot be read; it is solved without them
  double fraction = 0;       ///< progress of a task with an end, 0..1
  double solve_s = 0;        ///< computation time
  std::string trouble;       ///< why there is no result
};

/// Runs one task, a few frames at a time. Has no thread; driven by ComparisonRunner and by tests.
class ComparisonRun {
 public:
  /// Solvers of both runs, created on first use and reused by later runs.
  struct Solvers {
    std::shared_ptr<const MotionLibrary> library;
    std::vector<std::string> excluded_takes;
    std::unique_ptr<ReSolver> a, b;
  };
  /// The history and the solvers outlive the run.
  ComparisonRun(ComparisonTask task, const FrameHistory& recorded, Solvers& solvers);

  /// Solves up to `frames` further frames. @return false if there is nothing to do (now, or at all)
  bool advance(std::size_t frames);
  bool is_done() const { return state_.done; }
  /// The results with figures over all solved frames; for an endless task over the last 10 s with the same
  /// settings.
  std::shared_ptr<const Comparison> measured();

 private:
  void start(double from_s, double to_s);
  bool find_more();
  void solve(const FrameSnapshotPtr& recorded);
  void fail(const std::string& why);

  const FrameHistory& recorded_;
  Solvers& solvers_;
  Comparison state_;
  std::shared_ptr<FrameHistory> a_, b_;
  FrameRange waiting_;
  std::uint64_t solved_ = 0;  ///< number solved of waiting_
  FrameSnapshotPtr last_;     ///< last solved frame; null = none yet
};

}  // namespace abrazo
