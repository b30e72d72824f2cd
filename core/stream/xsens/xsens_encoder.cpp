#include "core/stream/xsens/xsens_encoder.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/text.hpp"
#include "core/stream/humanoid/humanoid_segments.hpp"
#include "core/stream/humanoid/joints_to_humanoid.hpp"
#include "core/stream/xsens/xsens_packet.hpp"

namespace abrazo {

namespace {

using namespace joints;

/// By segment: the humanoid's bone; L5 has none and is placed between pelvis and L3.
constexpr std::array<int, xsens_segment_count> bone_of_segment = {
    humanoid::Hips,          humanoid::Hips,          humanoid::Spine,     humanoid::Chest,
    humanoid::UpperChest,    humanoid::Neck,          humanoid::Head,      humanoid::RightShoulder,
    humanoid::RightUpperArm, humanoid::RightLowerArm, humanoid::RightHand, humanoid::LeftShoulder,
    humanoid::LeftUpperArm,  humanoid::LeftLowerArm,  humanoid::LeftHand,  humanoid::RightUpperLeg,
    humanoid::RightLowerLeg, humanoid::RightFoot,     humanoid::RightToes, humanoid::LeftUpperLeg,
    humanoid::LeftLowerLeg,  humanoid::LeftFoot,      humanoid::LeftToes};
constexpr std::size_t l5 = 1, l3 = 2;

/// To MVN's axes: x forward, z up.
Vec3 y_up_to_z_up(const Vec3& v) {
  return {v.z(), v.x(), v.y()};
}

/// Origins of the segments, Y up, with the rotations from the T-pose.
std::array<SegmentPose, xsens_segment_count> segments_of(const HumanoidPose& pose) {
  const PerBone<SegmentPose> bones = world_segments(pose);
  std::array<SegmentPose, xsens_segment_count> segments;
  for (std::size_t s = 0; s < segments.size(); ++s)
    segments[s] = bones[static_cast<std::size_t>(bone_of_segment[s])];
  segments[l5].position = 0.5 * (segments[0].position + segments[l3].position);
  return segments;
}

/// Points behind the last segments, as far away as the joint map "xsens" expects: crown, finger tips, tips of
/// the toes.
std::vector<XsensPoint> points_of(const Body& body) {
  const auto length = [&](int joint) { return body.bone_lengths[static_cast<std::size_t>(joint - 1)]; };
  constexpr double head_in_skull = 0.6, knuckles_in_hand = 0.5;
  const auto point = [](int segment, std::string name, const Vec3& offset) {
    return XsensPoint{segment, 1, std::move(name), y_up_to_z_up(offset)};
  };
  return {point(7, "pTopOfHead", Vec3(0, length(Head) / head_in_skull, 0)),
          point(11, "pRightTopOfHand", Vec3(-length(RightHand) / knuckles_in_hand, 0, 0)),
          point(15, "pLeftTopOfHand", Vec3(length(LeftHand) / knuckles_in_hand, 0, 0)),
          point(19, "pRightToe", Vec3(0, 0, length(RightToes))),
          point(23, "pLeftToe", Vec3(0, 0, length(LeftToes)))};
}

/// "RightUpperArm" -> "Right Upper Arm".
std::string spaced(std::string_view name) {
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool begins_word = i > 0 && name[i] >= 'A' && name[i] <= 'Z' && name[i - 1] >= 'a';
    text += begins_word ? std::string(" ") + name[i] : std::string(1, name[i]);
  }
  return text;
}

/// Names and places of the segments in the T-pose, Z up.
std::vector<std::pair<std::string, Vec3>> origins_of(const Body& body) {
  std::vector<std::pair<std::string, Vec3>> origins;
  const auto rest = segments_of(JointsToHumanoid(body).pose(t_pose(body), 0));
  for (std::size_t s = 0; s < rest.size(); ++s)
    origins.emplace_back(spaced(xsens_segment_names[s]), y_up_to_z_up(rest[s].position));
  return origins;
}

class XsensEncoder : public StreamEncoder {
 public:
  XsensEncoder(const Body& body, int character, std::string name)
      : humanoid_(body),
        character_(character),
        name_(std::move(name)),
        origins_(origins_of(body)),
        points_(points_of(body)) {}

  std::vector<std::vector<std::uint8_t>> packets(const OutgoingPose& pose) override;
  void set_body(const Body& body) override {
    humanoid_ = JointsToHumanoid(body);
    origins_ = origins_of(body);
    points_ = points_of(body);
    told_s_.reset();
  }
  void restart() override {
    sample_ = 0;
    told_s_.reset();
    humanoid_.restart();
  }

 private:
  std::vector<std::uint8_t> packet(XsensType type, int items, const OutgoingPose& pose,
                                   const ByteWriter& payload) const;
  void tell(const OutgoingPose& pose, std::vector<std::vector<std::uint8_t>>& packets) const;

  JointsToHumanoid humanoid_;
  int character_;
  std::string name_;
  std::vector<std::pair<std::string, Vec3>> origins_;  ///< in the T-pose, Z up
  std::vector<XsensPoint> points_;
  std::uint32_t sample_ = 0;
  std::optional<double> told_s_;  ///< when name and scale were sent last
};

std::vector<std::uint8_t> XsensEncoder::packet(XsensType type, int items, const OutgoingPose& pose,
                                               const ByteWriter& payload) const {
  XsensHeader header;
  header.type = static_cast<int>(type);
  header.sample = sample_;
  header.is_last = true;
  header.items = items;
  header.time_ms = static_cast<std::uint32_t>(std::llround(std::max(0.0, pose.time_s) * 1000));
  header.character = character_;
  header.payload_bytes = payload.size();
  ByteWriter writer(ByteOrder::Big);
  write_xsens_header(writer, header);
  std::vector<std::uint8_t> bytes = writer.take();
  bytes.insert(bytes.end(), payload.bytes().begin(), payload.bytes().end());
  return bytes;
}

/// Name and scale, the latter's segments and points apart as MVN does.
void XsensEncoder::tell(const OutgoingPose& pose, std::vector<std::vector<std::uint8_t>>& packets) const {
  ByteWriter meta(ByteOrder::Big), segments(ByteOrder::Big), points(ByteOrder::Big);
  write_xsens_meta(meta, {name_});
  write_xsens_scale(segments, {origins_, {}});
  write_xsens_scale(points, {{}, points_});
  packets.push_back(packet(XsensType::Meta, 1, pose, meta));
  packets.push_back(packet(XsensType::Scale, static_cast<int>(origins_.size()), pose, segments));
  packets.push_back(packet(XsensType::Scale, static_cast<int>(points_.size()), pose, points));
}

std::vector<std::vector<std::uint8_t>> XsensEncoder::packets(const OutgoingPose& pose) {
  std::vector<std::vector<std::uint8_t>> packets;
  constexpr double tell_every_s = 1;
  if (!told_s_ || pose.time_s - *told_s_ >= tell_every_s || pose.time_s < *told_s_) {
    told_s_ = pose.time_s;
    tell(pose, packets);
  }
  const auto segments = segments_of(humanoid_.pose(pose.pose, pose.time_s));
  ByteWriter payload(ByteOrder::Big);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Eigen::Quaterniond& q = segments[s].rotation;
    const Vec3 vector_part = y_up_to_z_up(q.vec());
    write_xsens_segment(payload,
                        {static_cast<int>(s + 1), y_up_to_z_up(segments[s].position),
                         Eigen::Quaterniond(q.w(), vector_part.x(), vector_part.y(), vector_part.z())});
  }
  packets.push_back(packet(XsensType::PoseQuaternion, xsens_segment_count, pose, payload));
  ++sample_;
  return packets;
}

}  // namespace

Result<std::unique_ptr<StreamEncoder>> make_xsens_encoder(const StreamUri& uri, const Body& body) {
  const auto character = parse_integer(uri.option("character", "0"));
  if (!character || *character < 0 || *character > 255)
    return Error{"character=" + uri.option("character") + " is not a number from 0 to 255", uri.text};
  for (const double length : body.bone_lengths)
    if (!std::isfinite(length) || length < 0)
      return Error{"a bone of the character is " + exact_text(length) + " m long; its body was not measured",
                   uri.text};
  return std::unique_ptr<StreamEncoder>(
      std::make_unique<XsensEncoder>(body, static_cast<int>(*character), uri.option("performer", "Abrazo")));
}

}  // namespace abrazo
