#include "tests/core/stream/vmc_packets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <numbers>
#include <stdexcept>

#include "core/motion/joints/joint_map.hpp"
#include "core/stream/vmc/vmc_decoder.hpp"

namespace abrazo::test {

Bytes from_hex(std::string_view hex) {
  Bytes bytes;
  std::string digits;
  for (const char c : hex)
    if (std::isxdigit(static_cast<unsigned char>(c)) != 0) digits += c;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2)
    bytes.push_back(static_cast<std::uint8_t>(std::stoi(digits.substr(i, 2), nullptr, 16)));
  return bytes;
}

OscElement unity_bone(const std::string& name, const Vec3& position, const Eigen::Quaterniond& rotation) {
  std::vector<OscArgument> arguments = {OscArgument::of(name)};
  for (const double value :
       {position.x(), position.y(), position.z(), rotation.x(), rotation.y(), rotation.z(), rotation.w()})
    arguments.push_back(OscArgument::of(static_cast<float>(value)));
  return osc_message("/VMC/Ext/Bone/Pos", arguments);
}

UnityPose t_pose() {
  UnityPose pose;
  const auto put = [&](const char* name, double x, double y, double z) { pose[name].position = {x, y, z}; };
  put("Hips", 0, 0.95, 0);
  put("Spine", 0, 0.1, 0);
  put("Chest", 0, 0.12, 0);
  put("UpperChest", 0, 0.12, 0);
  put("Neck", 0, 0.12, 0);
  put("Head", 0, 0.1, 0);
  for (const std::string side : {"Left", "Right"}) {
    const double x = side == "Left" ? -1 : 1;
    put((side + "Shoulder").c_str(), 0.03 * x, 0.08, 0);
    put((side + "UpperArm").c_str(), 0.13 * x, 0, 0);
    put((side + "LowerArm").c_str(), 0.27 * x, 0, 0);
    put((side + "Hand").c_str(), 0.25 * x, 0, 0);
    put((side + "UpperLeg").c_str(), 0.09 * x, -0.07, 0);
    put((side + "LowerLeg").c_str(), 0, -0.4, 0);
    put((side + "Foot").c_str(), 0, -0.4, 0);
    put((side + "Toes").c_str(), 0, -0.05, 0.13);
  }
  return pose;
}

Eigen::Quaterniond unity_rotation(double degrees, const Vec3& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis));
}

Bytes bundle_of(const std::vector<OscElement>& messages) {
  std::vector<OscElement> elements = {osc_bundle_begin()};
  elements.insert(elements.end(), messages.begin(), messages.end());
  elements.push_back(osc_bundle_end());
  return write_osc(elements);
}

OscElement osc_time(float seconds) {
  return osc_message("/VMC/Ext/T", {OscArgument::of(seconds)});
}

OscElement osc_ok(int loaded) {
  return osc_message("/VMC/Ext/OK", {OscArgument::of(loaded)});
}

std::vector<OscElement> bones_of(const UnityPose& pose) {
  std::vector<OscElement> bones;
  for (const auto& [name, bone] : pose) bones.push_back(unity_bone(name, bone.position, bone.rotation));
  return bones;
}

namespace {

OscElement root_message() {
  OscElement root = unity_bone("root", Vec3::Zero(), Eigen::Quaterniond::Identity());
  root.address = "/VMC/Ext/Root/Pos";
  return root;
}

}  // namespace

std::vector<Bytes> as_vmc_application(const UnityPose& pose, float time) {
  const std::vector<OscElement> bones = bones_of(pose);
  std::vector<Bytes> packets;
  std::size_t next = 0;
  for (; bones.size() - next > 12; next += 12)
    packets.push_back(bundle_of({bones.begin() + static_cast<std::ptrdiff_t>(next),
                                 bones.begin() + static_cast<std::ptrdiff_t>(next) + 12}));
  std::vector<OscElement> last = {root_message(), osc_bundle_begin()};
  for (; next < bones.size(); ++next) last.push_back(bones[next]);
  last.push_back(osc_bundle_end());
  last.push_back(osc_ok(1));
  last.push_back(osc_time(time));
  packets.push_back(bundle_of(last));
  return packets;
}

std::vector<Bytes> as_slimevr(const UnityPose& pose, float time) {
  std::vector<OscElement> messages = {osc_time(time), osc_ok(1), root_message()};
  for (const OscElement& bone : bones_of(pose)) messages.push_back(bone);
  return {bundle_of(messages)};
}

std::vector<Bytes> as_plain_messages(const UnityPose& pose, float time) {
  std::vector<Bytes> packets = {write_osc(std::vector{root_message()})};
  for (const OscElement& bone : bones_of(pose)) packets.push_back(write_osc(std::vector{bone}));
  packets.push_back(write_osc(std::vector{osc_ok(1)}));
  packets.push_back(write_osc(std::vector{osc_time(time)}));
  return packets;
}

Receiver::Receiver(const std::string& uri) {
  auto parsed = parse_stream_uri(uri);
  if (!parsed) throw std::invalid_argument(parsed.error().text());
  auto made = make_vmc_decoder(*parsed);
  if (!made) throw std::invalid_argument(made.error().text());
  decoder = std::move(*made);
}

void Receiver::take(const Bytes& packet, double arrived_s, const Endpoint& from) {
  decoder->take(Datagram{from, arrived_s, packet}, out);
}

void Receiver::take(const std::vector<Bytes>& packets, double arrived_s, const Endpoint& from) {
  for (std::size_t p = 0; p < packets.size(); ++p)
    take(packets[p], arrived_s + 1e-4 * static_cast<double>(p), from);
}

bool Receiver::has_point(const std::string& name) const {
  if (out.frames.empty()) return false;
  const auto& names = *out.frames.back().points;
  return std::find(names.begin(), names.end(), name) != names.end();
}

Vec3 Receiver::point(const std::string& name) const {
  if (!has_point(name)) {
    ADD_FAILURE() << "no point " << name;
    return Vec3::Zero();
  }
  const auto& names = *out.frames.back().points;
  return out.frames.back()
      .positions.row(std::find(names.begin(), names.end(), name) - names.begin())
      .transpose();
}

int Receiver::count(const std::string& kind) const {
  return static_cast<int>(std::count_if(out.issues.begin(), out.issues.end(),
                                        [&](const StreamIssue& issue) { return issue.kind == kind; }));
}

std::string Receiver::text(const std::string& kind) const {
  for (const StreamIssue& issue : out.issues)
    if (issue.kind == kind) return issue.text;
  return "no issue " + kind;
}

Pose Receiver::joints() const {
  for (const JointMap& map : builtin_joint_maps()) {
    if (map.name != "unity" || out.frames.empty()) continue;
    const JointBinding binding = bind_joints(map, *out.frames.back().points);
    EXPECT_TRUE(binding.missing.empty());
    return binding.joints_of(out.frames.back().positions);
  }
  ADD_FAILURE() << "no frame";
  return Pose::Zero();
}

}  // namespace abrazo::test
