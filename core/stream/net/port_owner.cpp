#include "core/stream/net/port_owner.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>

#include "core/base/text.hpp"
#include "core/stream/net/usual_ports.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

struct UsualOwner {
  std::uint16_t port;
  std::string_view programs;
};

constexpr std::array usual_owners = {
    UsualOwner{vmc_port, "VSeeFace, Warudo, a Unity or Unreal receiver, or another Abrazo"},
    UsualOwner{vmc_sender_port, "Virtual Motion Capture, or another Abrazo"},
    UsualOwner{natnet_command_port, "Motive, or another Abrazo"},
    UsualOwner{natnet_data_port, "Motive, another NatNet client, or another Abrazo"},
    UsualOwner{xsens_port, "Xsens MVN, another of its receivers, or another Abrazo"}};

/// The kernel's number of the socket that is bound to the port ("sl local_address rem_address st ... inode").
std::optional<std::string> socket_number(std::uint16_t port) {
  std::ifstream table("/proc/net/udp");
  std::string line;
  std::getline(table, line);
  while (std::getline(table, line)) {
    const auto words = split_words(line);
    if (words.size() < 10) continue;
    const auto colon = words[1].find(':');
    if (colon == std::string_view::npos) continue;
    const std::string hex(words[1].substr(colon + 1));
    if (std::strtoul(hex.c_str(), nullptr, 16) == port) return std::string(words[9]);
  }
  return std::nullopt;
}

bool holds(const fs::path& process, const std::string& link) {
  std::error_code failure;
  for (fs::directory_iterator entry(process / "fd", failure), end; !failure && entry != end;
       entry.increment(failure)) {
    std::error_code gone;
    if (fs::read_symlink(entry->path(), gone) == link && !gone) return true;
  }
  return false;
}

/// Nothing where the process belongs to another user.
std::optional<std::string> program_with(const std::string& link) {
  std::error_code failure;
  for (fs::directory_iterator process("/proc", failure), end; !failure && process != end;
       process.increment(failure)) {
    const std::string id = process->path().filename().string();
    if (!parse_integer(id) || !holds(process->path(), link)) continue;
    std::ifstream name_file(process->path() / "comm");
    std::string name;
    std::getline(name_file, name);
    return in_quotes(name) + " (process " + id + ")";
  }
  return std::nullopt;
}

}  // namespace

std::string describe_port_owner(std::uint16_t port) {
  if (const auto number = socket_number(port))
    if (const auto program = program_with("socket:[" + *number + "]")) return *program;
  for (const UsualOwner& usual : usual_owners)
    if (usual.port == port) return "another program (" + std::string(usual.programs) + ")";
  return "another program";
}

}  // namespace abrazo
