#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "core/session/frames/latest_slot.hpp"
#include "core/session/run/comparison.hpp"

namespace abrazo {

/// Runs comparisons on a separate thread beside the live solver. A new task replaces the present one at once.
/// Destruction stops it within one frame.
class ComparisonRunner {
 public:
  /// @param recorded  outlives the runner
  ComparisonRunner(std::shared_ptr<const MotionLibrary> library, std::vector<std::string> excluded_takes,
                   const FrameHistory& recorded);
  ~ComparisonRunner();

  void ask(const ComparisonTask& task);
  /// Stops solving; published results stay.
  void cancel();
  /// The newest result of any task, if newer than `seen`; @see LatestSlot
  std::shared_ptr<const Comparison> take_if_newer(std::uint64_t& seen) const {
    return results_.take_if_newer(seen);
  }

 private:
  void serve(const std::stop_token& stop);
  void carry_out(const ComparisonTask& task, std::uint64_t version, const std::stop_token& stop);
  bool is_wanted(std::uint64_t version);

  ComparisonRun::Solvers solvers_;
  const FrameHistory& recorded_;
  LatestSlot<Comparison> results_;
  std::mutex mutex_;
  std::condition_variable_any asked_;
  std::optional<ComparisonTask> task_;
  std::uint64_t version_ = 0;
  std::jthread thread_;  // last: joined first
};

}  // namespace abrazo
