#include "core/session/run/comparison_runner.hpp"

#include <chrono>
#include <exception>

#include "core/base/thread_urgency.hpp"

namespace abrazo {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t frames_at_once = 8;          // some milliseconds: a new task waits no longer
constexpr std::chrono::milliseconds nap(4);        // until the live solver has added something
constexpr std::chrono::milliseconds between(400);  // results: measuring takes a few milliseconds

}  // namespace

ComparisonRunner::ComparisonRunner(std::shared_ptr<const MotionLibrary> library,
                                   std::vector<std::string> excluded_takes, const FrameHistory& recorded)
    : solvers_{std::move(library), std::move(excluded_takes), nullptr, nullptr},
      recorded_(recorded),
      thread_([this](const std::stop_token& stop) { serve(stop); }) {}

ComparisonRunner::~ComparisonRunner() = default;

void ComparisonRunner::ask(const ComparisonTask& task) {
  {
    const std::scoped_lock lock(mutex_);
    task_ = task;
    ++version_;
  }
  asked_.notify_all();
}

void ComparisonRunner::cancel() {
  const std::scoped_lock lock(mutex_);
  task_.reset();
  ++version_;
}

bool ComparisonRunner::is_wanted(std::uint64_t version) {
  const std::scoped_lock lock(mutex_);
  return version == version_;
}

void ComparisonRunner::serve(const std::stop_token& stop) {
  let_others_go_first();
  std::uint64_t done = 0;
  while (!stop.stop_requested()) {
    ComparisonTask task;
    {
      std::unique_lock lock(mutex_);
      if (!asked_.wait(lock, stop, [&] { return task_ && version_ != done; })) return;
      task = *task_;
      done = version_;
    }
    try {
      carry_out(task, done, stop);
    } catch (const std::exception& failure) {
      auto result = std::make_shared<Comparison>();
      result->task = task;
      result->trouble = failure.what();
      result->done = true;
      results_.publish(std::move(result));
    }
  }
}

void ComparisonRunner::carry_out(const ComparisonTask& task, std::uint64_t version,
                                 const std::stop_token& stop) {
  ComparisonRun run(task, recorded_, solvers_);
  auto due = Clock::now() + between / 4;
  bool is_news = false;
  while (!stop.stop_requested() && is_wanted(version) && !run.is_done()) {
    const bool worked = run.advance(frames_at_once);
    is_news |= worked;
    if (is_news && Clock::now() >= due && !run.is_done()) {
      results_.publish(run.measured());
      due = Clock::now() + between;
      is_news = false;
    }
    if (worked) continue;
    std::unique_lock lock(mutex_);
    asked_.wait_for(lock, stop, nap, [&] { return version != version_; });
  }
  if (run.is_done() && is_wanted(version)) results_.publish(run.measured());
}

}  // namespace abrazo
