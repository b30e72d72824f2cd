#include "app/cli/command_line.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <memory>

namespace abrazo::app {

void fail(CommandLine& line, const Error& error) {
  fmt::print(stderr, "abrazo: {}\n", error.text());
  line.status = 1;
}

Progress terminal_progress(const CommandLine& line) {
  if (line.quiet || ::isatty(STDERR_FILENO) == 0) return {};
  return [last = -1](double fraction, std::string_view doing) mutable {
    const int percent = static_cast<int>(fraction * 100);
    if (percent != last) fmt::print(stderr, "\r\033[K{:3d} %  {}", percent, doing);
    if (percent >= 100 && last != percent) fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);
    last = percent;
    return true;
  };
}

}  // namespace abrazo::app
