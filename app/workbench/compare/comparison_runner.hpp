#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "app/workbench/compare/comparison.hpp"
#include "core/session/frames/latest_slot.hpp"

namespace abrazo::app {

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
    return m_results.take_if_newer(seen);
  }

 private:
  void serve(const std::stop_token& stop);
  void carryOut(const ComparisonTask& task, std::uint64_t version, const std::stop_token& stop);
  bool isWanted(std::uint64_t version);

  ComparisonRun::Solvers m_solvers;
  const FrameHistory& m_recorded;
  LatestSlot<Comparison> m_results;
  std::mutex m_mutex;
  std::condition_variable_any m_asked;
  std::optional<ComparisonTask> m_task;
  std::uint64_t m_version = 0;
  std::jthread m_thread;  // last: joined first
};

}  // namespace abrazo::app
