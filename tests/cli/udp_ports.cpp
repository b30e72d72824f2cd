#include "tests/cli/udp_ports.hpp"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <string>

#include "core/stream/net/udp_socket.hpp"

namespace abrazo::test {

namespace {

/// Ports stand in the system's tables as "0100007F:9A73", hexadecimal, in the second column.
bool stands_in(const char* table, std::uint16_t port) {
  std::ifstream in(table);
  const std::string end = fmt::format(":{:04X}", port);
  std::string line, number, local;
  std::getline(in, line);
  while (std::getline(in, line)) {
    std::istringstream columns(line);
    if (columns >> number >> local && local.ends_with(end)) return true;
  }
  return false;
}

}  // namespace

std::uint16_t free_port() {
  return UdpSocket::bind({this_machine, 0})->local().port;
}

bool is_open(std::uint16_t port) {
  return stands_in("/proc/net/udp", port) || stands_in("/proc/net/udp6", port);
}

}  // namespace abrazo::test
