#include "tests/core/stream/natnet_packets.hpp"

#include "core/stream/natnet/natnet_encoder.hpp"

namespace abrazo::natnet_test {

using Eigen::Quaterniond;
using test::Listener;

std::vector<std::uint8_t> server_info(NatNetVersion version, bool multicast) {
  NatNetServerInfo info;
  info.application = "Motive";
  info.application_version[0] = 3;
  info.application_version[1] = 1;
  info.version = version;
  info.clock_hz = 1000;
  info.data_port = 1515;
  info.multicast = multicast;
  info.group = 0xEFFF2A63;  // 239.255.42.99
  ByteWriter writer(ByteOrder::Little);
  write_natnet_server_info(writer, info);
  return natnet_packet(NatNetMessage::ServerInfo, writer);
}

std::vector<std::uint8_t> model_packet(const std::vector<NatNetSkeleton>& skeletons, NatNetVersion version) {
  NatNetModel model;
  model.skeletons = skeletons;
  ByteWriter writer(ByteOrder::Little);
  write_natnet_model(writer, model, version);
  return natnet_packet(NatNetMessage::ModelDef, writer);
}

std::vector<std::uint8_t> frame_packet(const NatNetFrame& frame, NatNetVersion version) {
  ByteWriter writer(ByteOrder::Little);
  write_natnet_frame(writer, frame, version);
  return natnet_packet(NatNetMessage::Frame, writer);
}

NatNetSkeleton skeleton(const std::string& name, std::int32_t id) {
  return {name,
          id,
          {{"Hip", 1, 0, Vec3::Zero()},
           {"Chest", 2, 1, Vec3(0, 0.5, 0)},
           {"Head", 3, 2, Vec3(0, 0.3, 0)},
           {"LFArm", 4, 2, Vec3(0.2, 0.2, 0)},
           {"LHand", 5, 4, Vec3(0.25, 0, 0)}}};
}

NatNetSkeletonFrame posed(const NatNetSkeleton& of, bool local, double yaw) {
  NatNetSkeletonFrame frame{of.id, {}};
  std::vector<Vec3> places;
  const Quaterniond turn(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  for (const NatNetBone& bone : of.bones) {
    const auto parent = static_cast<std::size_t>(bone.parent - 1);
    places.push_back(bone.parent == 0 ? hip_world : Vec3(places[parent] + turn * bone.offset));
    NatNetBody body;
    body.id = of.id << 16 | bone.id;
    body.position = local && bone.parent > 0 ? bone.offset : places.back();
    body.rotation = local && bone.parent > 0 ? Quaterniond::Identity() : turn;
    body.tracked = true;
    frame.bones.push_back(body);
  }
  return frame;
}

NatNetFrame frame_of(const std::vector<NatNetSkeletonFrame>& skeletons, std::int32_t number) {
  NatNetFrame frame;
  frame.number = number;
  frame.skeletons = skeletons;
  frame.time_s = 12.5;
  frame.stamps = NatNetStamps{1000, 1003, 1005};
  return frame;
}

Listener connected(const std::vector<NatNetSkeleton>& skeletons, std::string_view uri,
                   NatNetVersion version) {
  Listener listener(uri);
  listener.pass_time(0);
  listener.take(server_info(version));
  listener.pass_time(0);
  listener.take(model_packet(skeletons, version));
  listener.forget();
  return listener;
}

}  // namespace abrazo::natnet_test
