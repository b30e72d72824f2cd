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

/// What the argument `progress` of a long job asks for: None or False nothing, True a line on sys.stderr, a
/// function is called with (fraction, doing) some ten times a second and stops the job by returning False.
/// Ctrl+C stops it in each case.
class CalledProgress {
 public:
  explicit CalledProgress(py::object wish) : wish_(std::move(wish)) {}

  /// Runs `job(progress)` without the GIL and gives its value.
  /// @throws what stopped it: KeyboardInterrupt or what the function raised; EngineError
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
  /// With the GIL. @return false when the job should stop
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
