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

/// Carries out comparisons on a thread of its own, beside the live solver. A new task takes the place of the
/// one before, at once. Destruction stops within a frame.
class ComparisonRunner {
 public:
  /// @param recorded  outlives the runner
  ComparisonRunner(std::shared_ptr<const MotionLibrary> library, std::vector<std::string> excluded_takes,
                   const FrameHistory& recorded);
  ~ComparisonRunner();

  void ask(const ComparisonTask& task);
  /// Nothing is solved any more; what was published stays.
  void cancel();
  /// What came last of any task, if it is newer; @see LatestSlot
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
