#include "app/workbench/compare/comparison_runner.hpp"

#include <chrono>
#include <exception>

namespace abrazo::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t frames_at_once = 8;          // some milliseconds: a new task waits no longer
constexpr std::chrono::milliseconds nap(4);        // until the live solver has added something
constexpr std::chrono::milliseconds between(400);  // results: measuring takes a few milliseconds

}  // namespace

ComparisonRunner::ComparisonRunner(std::shared_ptr<const MotionLibrary> library,
                                   std::vector<std::string> excluded_takes, const FrameHistory& recorded)
    : m_solvers{std::move(library), std::move(excluded_takes), nullptr, nullptr},
      m_recorded(recorded),
      m_thread([this](const std::stop_token& stop) { serve(stop); }) {}

ComparisonRunner::~ComparisonRunner() = default;

void ComparisonRunner::ask(const ComparisonTask& task) {
  {
    const std::scoped_lock lock(m_mutex);
    m_task = task;
    ++m_version;
  }
  m_asked.notify_all();
}

void ComparisonRunner::cancel() {
  const std::scoped_lock lock(m_mutex);
  m_task.reset();
  ++m_version;
}

bool ComparisonRunner::isWanted(std::uint64_t version) {
  const std::scoped_lock lock(m_mutex);
  return version == m_version;
}

void ComparisonRunner::serve(const std::stop_token& stop) {
  std::uint64_t done = 0;
  while (!stop.stop_requested()) {
    ComparisonTask task;
    {
      std::unique_lock lock(m_mutex);
      if (!m_asked.wait(lock, stop, [&] { return m_task && m_version != done; })) return;
      task = *m_task;
      done = m_version;
    }
    try {
      carryOut(task, done, stop);
    } catch (const std::exception& failure) {
      auto result = std::make_shared<Comparison>();
      result->task = task;
      result->trouble = failure.what();
      result->done = true;
      m_results.publish(std::move(result));
    }
  }
}

void ComparisonRunner::carryOut(const ComparisonTask& task, std::uint64_t version,
                                const std::stop_token& stop) {
  ComparisonRun run(task, m_recorded, m_solvers);
  auto due = Clock::now() + between / 4;
  bool is_news = false;
  while (!stop.stop_requested() && isWanted(version) && !run.isDone()) {
    const bool worked = run.advance(frames_at_once);
    is_news |= worked;
    if (is_news && Clock::now() >= due && !run.isDone()) {
      m_results.publish(run.measured());
      due = Clock::now() + between;
      is_news = false;
    }
    if (worked) continue;
    std::unique_lock lock(m_mutex);
    m_asked.wait_for(lock, stop, nap, [&] { return version != m_version; });
  }
  if (run.isDone() && isWanted(version)) m_results.publish(run.measured());
}

}  // namespace abrazo::app
