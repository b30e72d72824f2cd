#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <optional>
#include <string>
#include <string_view>

#include "app/python/binding.hpp"
#include "core/base/progress.hpp"

namespace abrazo::python {

/// The argument `progress` of a long job: None or False for none, True for a line on sys.stderr, or a
/// function called with (fraction, doing) about ten times per second that cancels the job by returning False.
/// Ctrl+C always cancels.
class CalledProgress {
 public:
  explicit CalledProgress(py::object wish) : wish_(std::move(wish)) {}

  /// Runs `job(progress)` without the GIL and returns its value.
  /// @throws KeyboardInterrupt, the exception of the function, or EngineError
  template <typename Job>
  auto run(Job job) {
    auto result = without_gil([&] {
      return job(Progress([this](double fraction, std::string_view doing) { return call(fraction, doing); }));
    });
    end_line();
    if (raised_) std::rethrow_exception(raised_);
    return unwrap(std::move(result));
  }

 private:
  bool call(double fraction, std::string_view doing);
  /// Called with the GIL. @return false if the job should stop
  bool tell(double fraction, std::string_view doing);
  void end_line();

  using Clock = std::chrono::steady_clock;
  py::object wish_;
  std::atomic<Clock::rep> next_ = 0;  ///< jobs may report from several threads
  std::atomic<bool> stopped_ = false;
  std::exception_ptr raised_;
  bool has_line_ = false;
};

}  // namespace abrazo::python
