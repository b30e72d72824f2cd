#include "core/stream/natnet/natnet_encoder.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/text.hpp"
#include "core/base/version.hpp"
#include "core/stream/humanoid/humanoid_segments.hpp"
#include "core/stream/humanoid/joints_to_humanoid.hpp"
#include "core/stream/natnet/natnet_frame.hpp"
#include "core/stream/natnet/natnet_model.hpp"

namespace abrazo {

namespace {

constexpr double clock_hz = 10'000'000;
constexpr std::int32_t skeleton_id = 1;
constexpr NatNetVersion usual_version{4, 1};

/// A bone of Motive's core skeleton, in the order in which Motive sends them.
struct MotiveBone {
  std::string_view name;
  int bone;    ///< of a humanoid
  int parent;  ///< number (from 1 on), 0 for none
};

constexpr std::array<MotiveBone, 21> motive_bones = {{{"Hip", humanoid::Hips, 0},
                                                      {"Ab", humanoid::Spine, 1},
                                                      {"Chest", humanoid::Chest, 2},
                                                      {"Neck", humanoid::Neck, 3},
                                                      {"Head", humanoid::Head, 4},
                                                      {"LShoulder", humanoid::LeftShoulder, 3},
                                                      {"LUArm", humanoid::LeftUpperArm, 6},
                                                      {"LFArm", humanoid::LeftLowerArm, 7},
                                                      {"LHand", humanoid::LeftHand, 8},
                                                      {"RShoulder", humanoid::RightShoulder, 3},
                                                      {"RUArm", humanoid::RightUpperArm, 10},
                                                      {"RFArm", humanoid::RightLowerArm, 11},
                                                      {"RHand", humanoid::RightHand, 12},
                                                      {"LThigh", humanoid::LeftUpperLeg, 1},
                                                      {"LShin", humanoid::LeftLowerLeg, 14},
                                                      {"LFoot", humanoid::LeftFoot, 15},
                                                      {"RThigh", humanoid::RightUpperLeg, 1},
                                                      {"RShin", humanoid::RightLowerLeg, 17},
                                                      {"RFoot", humanoid::RightFoot, 18},
                                                      {"LToe", humanoid::LeftToes, 16},
                                                      {"RToe", humanoid::RightToes, 19}}};

NatNetModel model_of(const Body& body, const std::string& name) {
  const PerBone<SegmentPose> rest = world_segments(JointsToHumanoid(body).pose(t_pose(body), 0));
  const auto place = [&](const MotiveBone& bone) {
    return rest[static_cast<std::size_t>(bone.bone)].position;
  };
  NatNetSkeleton skeleton{name, skeleton_id, {}};
  for (std::size_t b = 0; b < motive_bones.size(); ++b) {
    const MotiveBone& bone = motive_bones[b];
    const Vec3 offset =
        bone.parent > 0 ? Vec3(place(bone) - place(motive_bones[static_cast<std::size_t>(bone.parent - 1)]))
                        : Vec3(Vec3::Zero());
    skeleton.bones.push_back({std::string(bone.name), static_cast<std::int32_t>(b + 1), bone.parent, offset});
  }
  NatNetModel model;
  model.skeletons.push_back(std::move(skeleton));
  return model;
}

class NatNetEncoder : public StreamEncoder {
 public:
  NatNetEncoder(const Body& body, std::string name, NatNetServerInfo info)
      : humanoid_(body), info_(std::move(info)), name_(std::move(name)), model_packet_(model_packet(body)) {}

  std::vector<std::vector<std::uint8_t>> packets(const OutgoingPose& pose) override;
  bool answer(const Datagram& question, std::vector<OutgoingDatagram>& answers) override;
  void set_body(const Body& body) override {
    humanoid_ = JointsToHumanoid(body);
    model_packet_ = model_packet(body);
    model_changed_ = true;
  }
  void restart() override {
    number_ = 0;
    humanoid_.restart();
  }

 private:
  std::vector<std::uint8_t> model_packet(const Body& body) const {
    ByteWriter model(ByteOrder::Little);
    write_natnet_model(model, model_of(body, name_), info_.version);
    return natnet_packet(NatNetMessage::ModelDef, model);
  }
  bool tells_change(double time_s);

  JointsToHumanoid humanoid_;
  NatNetServerInfo info_;
  std::string name_;
  std::vector<std::uint8_t> model_packet_;
  std::int32_t number_ = 0;
  bool model_changed_ = false;      ///< since the last frame
  std::optional<double> change_s_;  ///< when the last change was first announced
};

/// For a while, because packets may be lost: an informed client requests the model again.
bool NatNetEncoder::tells_change(double time_s) {
  constexpr double told_for_s = 0.5;
  if (std::exchange(model_changed_, false)) change_s_ = time_s;
  return change_s_ && time_s >= *change_s_ && time_s - *change_s_ < told_for_s;
}

std::uint64_t ticks(double time_s) {
  return time_s > 0 ? static_cast<std::uint64_t>(time_s * clock_hz) : 0;
}

std::vector<std::vector<std::uint8_t>> NatNetEncoder::packets(const OutgoingPose& pose) {
  const PerBone<SegmentPose> segments = world_segments(humanoid_.pose(pose.pose, pose.time_s));
  NatNetFrame frame;
  frame.number = number_++;
  NatNetSkeletonFrame skeleton{skeleton_id, {}};
  for (std::size_t b = 0; b < motive_bones.size(); ++b) {
    const SegmentPose& segment = segments[static_cast<std::size_t>(motive_bones[b].bone)];
    NatNetBody bone;
    bone.id = skeleton_id << 16 | static_cast<std::int32_t>(b + 1);
    bone.position = segment.position;
    bone.rotation = segment.rotation;
    bone.tracked = pose.tracked;
    skeleton.bones.push_back(bone);
  }
  frame.skeletons.push_back(std::move(skeleton));
  frame.time_s = pose.time_s;
  frame.models_changed = tells_change(pose.time_s);
  frame.stamps = NatNetStamps{ticks(pose.time_s), ticks(pose.time_s), ticks(pose.time_s)};
  ByteWriter payload(ByteOrder::Little);
  write_natnet_frame(payload, frame, info_.version);
  return {natnet_packet(NatNetMessage::Frame, payload)};
}

bool NatNetEncoder::answer(const Datagram& question, std::vector<OutgoingDatagram>& answers) {
  ByteReader reader(question.bytes, ByteOrder::Little);
  const NatNetHead head = parse_natnet_head(reader);
  if (reader.failed()) return false;
  ByteWriter payload(ByteOrder::Little);
  switch (static_cast<NatNetMessage>(head.id)) {
    case NatNetMessage::Connect:
    case NatNetMessage::Discovery:
      write_natnet_server_info(payload, info_);
      answers.push_back({question.from, natnet_packet(NatNetMessage::ServerInfo, payload)});
      return static_cast<NatNetMessage>(head.id) == NatNetMessage::Connect;
    case NatNetMessage::RequestModelDef:
      answers.push_back({question.from, model_packet_});
      return true;
    case NatNetMessage::EchoRequest:
      payload.u64(reader.u64("the asker's time stamp"));
      payload.u64(ticks(question.arrived_s));
      if (!reader.failed())
        answers.push_back({question.from, natnet_packet(NatNetMessage::EchoResponse, payload)});
      return true;
    case NatNetMessage::KeepAlive:
    case NatNetMessage::RequestFrame:
      return true;
    case NatNetMessage::Request:  // a command for Motive, not supported here
      answers.push_back({question.from, natnet_packet(NatNetMessage::Unrecognized, payload)});
      return true;
    default:
      return false;
  }
}

}  // namespace

Result<std::unique_ptr<StreamEncoder>> make_natnet_encoder(const StreamUri& uri, const Body& body) {
  NatNetServerInfo info;
  info.application = "Abrazo";
  info.version = usual_version;
  info.clock_hz = static_cast<std::uint64_t>(clock_hz);
  if (const std::string given = uri.option("version"); !given.empty()) {
    const auto version = parse_natnet_version(given);
    if (!version || *version > natnet_with_section_sizes)
      return Error{"version=" + given + " is not known; expected 3.0, 3.1, 4.0 or 4.1", uri.text};
    info.version = *version;
  }
  if (const std::string group = uri.option("multicast"); !group.empty()) {
    const auto address = parse_natnet_group(group);
    if (!address)
      return Error{"multicast=" + group + " is not a group from 224.0.0.0 to 239.255.255.255", uri.text};
    info.multicast = true;
    info.group = *address;
  }
  for (const double length : body.bone_lengths)
    if (!std::isfinite(length) || length < 0)
      return Error{"a bone of the character is " + exact_text(length) + " m long; its body was not measured",
                   uri.text};
  const std::vector<std::string_view> numbers = split_fields(version(), '.');
  for (std::size_t i = 0; i < numbers.size() && i < 4; ++i)
    info.application_version[i] = static_cast<int>(parse_integer(numbers[i]).value_or(0));
  return std::unique_ptr<StreamEncoder>(
      std::make_unique<NatNetEncoder>(body, uri.option("performer", "Abrazo"), std::move(info)));
}

}  // namespace abrazo
