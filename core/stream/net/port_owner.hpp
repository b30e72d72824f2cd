#pragma once

#include <cstdint>
#include <string>

namespace abrazo {

/// Who holds a UDP port of this machine, for people: the program's name where the system tells it, else the
/// programs that usually do ("VSeeFace, Warudo, ...").
std::string describe_port_owner(std::uint16_t port);

}  // namespace abrazo
