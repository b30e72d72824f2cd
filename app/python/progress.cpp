#include "app/python/progress.hpp"

#include <fmt/format.h>

namespace abrazo::python {

namespace {

void write_stderr(const std::string& text) {
  const py::object stream = py::module_::import("sys").attr("stderr");
  stream.attr("write")(text);
  stream.attr("flush")();
}

}  // namespace

bool CalledProgress::call(double fraction, std::string_view doing) {
  if (stopped_) return false;
  const Clock::rep now = Clock::now().time_since_epoch().count();
  if (now < next_ && fraction < 1) return true;
  const py::gil_scoped_acquire acquired;
  next_ = now + Clock::duration(std::chrono::milliseconds(100)).count();
  try {
    stopped_ = !tell(fraction, doing);
  } catch (...) {
    raised_ = std::current_exception();
    stopped_ = true;
  }
  return !stopped_;
}

bool CalledProgress::tell(double fraction, std::string_view doing) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  if (py::isinstance<py::bool_>(wish_) && wish_.cast<bool>()) {
    has_line_ = true;
    write_stderr(fmt::format("\r{:3d} %  {:<40}", static_cast<int>(100 * fraction), doing));
  }
  if (!PyCallable_Check(wish_.ptr())) return true;
  const py::object answer = wish_(fraction, std::string(doing));
  return answer.is_none() || answer.cast<bool>();
}

void CalledProgress::end_line() {
  if (has_line_) write_stderr("\n");
}

}  // namespace abrazo::python
