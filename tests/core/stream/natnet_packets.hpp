#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/stream/natnet/natnet_frame.hpp"
#include "core/stream/natnet/natnet_model.hpp"
#include "tests/core/stream/mocap_stream.hpp"

namespace abrazo::natnet_test {

inline constexpr NatNetVersion v41{4, 1};
inline const Vec3 hip_world(3, 1, 2);

std::vector<std::uint8_t> server_info(NatNetVersion version, bool multicast = false);
std::vector<std::uint8_t> model_packet(const std::vector<NatNetSkeleton>& skeletons, NatNetVersion version);
std::vector<std::uint8_t> frame_packet(const NatNetFrame& frame, NatNetVersion version);

/// Hip at 1 m, chest 0.5 m above, head 0.3 m above that; a left arm of two bones and a hand.
NatNetSkeleton skeleton(const std::string& name, std::int32_t id);
/// That skeleton with the hip turned about y, the rest in the rest pose.
NatNetSkeletonFrame posed(const NatNetSkeleton& of, bool local, double yaw = 0.5);
NatNetFrame frame_of(const std::vector<NatNetSkeletonFrame>& skeletons, std::int32_t number = 1);

/// A listener that knows a server with these skeletons.
test::Listener connected(const std::vector<NatNetSkeleton>& skeletons,
                         std::string_view uri = "natnet://10.0.0.5", NatNetVersion version = v41);

}  // namespace abrazo::natnet_test
