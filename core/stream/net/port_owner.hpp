#pragma once

#include <cstdint>
#include <string>

namespace abrazo {

/// The program that holds a UDP port of this machine, for messages: its name if the system gives it, else
/// programs that usually do ("VSeeFace, Warudo, ...").
std::string describe_port_owner(std::uint16_t port);

}  // namespace abrazo
