#pragma once

#include <cstdint>

namespace abrazo {

// UDP ports that the programs use unless they are set up differently.

inline constexpr std::uint16_t vmc_port = 39539;         ///< receiver of a performer
inline constexpr std::uint16_t vmc_sender_port = 39540;  ///< receiver of Virtual Motion Capture
inline constexpr std::uint16_t natnet_command_port = 1510;
inline constexpr std::uint16_t natnet_data_port = 1511;
inline constexpr std::uint16_t xsens_port = 9763;

}  // namespace abrazo
