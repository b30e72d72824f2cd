#include "app/cli/virtual_display.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>

#include "core/base/text.hpp"

namespace abrazo::app {
namespace {

constexpr int patience_ms = 30'000;  // a loaded machine

const char* const advice = "install the package xvfb, or set DISPLAY to an existing display";

/// What the server writes when it is ready: the number of its display. Empty when it does not come.
std::string read_number(int from) {
  std::string text;
  std::array<char, 32> bytes{};
  while (text.find('\n') == std::string::npos) {
    pollfd ready{from, POLLIN, 0};
    if (::poll(&ready, 1, patience_ms) <= 0) return {};
    const ssize_t count = ::read(from, bytes.data(), bytes.size());
    if (count <= 0) return {};
    text.append(bytes.data(), static_cast<std::size_t>(count));
  }
  return std::string(trimmed(text));
}

}  // namespace

Result<VirtualDisplay> VirtualDisplay::start() {
  std::array<int, 2> number{};
  if (::pipe2(number.data(), O_CLOEXEC) != 0)
    return Error{"no pipe to the virtual display can be made", "Xvfb"};
  // Does not receive Ctrl-C: it must outlive the processes that are being stopped.
  auto server = ChildProcess::start(
      {{"Xvfb", "-displayfd", std::to_string(number[1]), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"},
       {},
       number[1],
       true,
       true});
  ::close(number[1]);
  const std::string name = server ? read_number(number[0]) : "";
  ::close(number[0]);
  if (!server)
    return Error{std::string("there is no display, and Xvfb, which would provide a virtual one, is not "
                             "installed: ") +
                     advice,
                 "DISPLAY"};
  if (!parse_integer(name))
    return Error{std::string("there is no display, and Xvfb did not start: ") + advice, "DISPLAY"};
  return VirtualDisplay(std::move(server).value(), ":" + name);
}

}  // namespace abrazo::app
