#include "core/stream/vmc/vmc_performer.hpp"

#include <algorithm>
#include <functional>
#include <string_view>

namespace abrazo {

namespace {

/// A packet with the same bytes within this time came twice; later it is a pose that did not change [s].
constexpr double duplicate_s = 0.003;
constexpr std::size_t most_recent = 64;
constexpr std::size_t most_unknown_bones = 32;
constexpr std::size_t longest_name = 40;

}  // namespace

bool VmcPerformer::is_duplicate(const Datagram& datagram) {
  const std::string_view bytes(reinterpret_cast<const char*>(datagram.bytes.data()), datagram.bytes.size());
  const std::size_t hash = std::hash<std::string_view>{}(bytes);
  while (!recent_.empty() &&
         (datagram.arrived_s - recent_.front().second > duplicate_s || recent_.size() > most_recent))
    recent_.pop_front();
  const bool known =
      std::any_of(recent_.begin(), recent_.end(), [&](const auto& packet) { return packet.first == hash; });
  if (!known) recent_.emplace_back(hash, datagram.arrived_s);
  return known;
}

void VmcPerformer::take(const OscPacket& packet, const Datagram& datagram, Decoded& out) {
  finish(framing_.silence(datagram.arrived_s), out);
  last_s_ = datagram.arrived_s;
  if (first_s_ < 0) first_s_ = last_s_;
  if (is_duplicate(datagram)) {
    out.issues.push_back({"duplicate-packet", name_ + ": a packet came twice; the second one is left out"});
    return;
  }
  framing_.packet_begins();
  for (const OscElement& element : packet.elements) {
    switch (element.kind) {
      case OscElement::Kind::BundleBegin:
        framing_.bundle_begins();
        break;
      case OscElement::Kind::BundleEnd:
        finish(framing_.bundle_ends(), out);
        break;
      case OscElement::Kind::Message:
        if (const auto read = read_vmc(element, out.issues)) message(*read, datagram.arrived_s, out);
        break;
    }
  }
}

void VmcPerformer::message(const VmcMessage& message, double arrived_s, Decoded& out) {
  if (const auto* const time = std::get_if<VmcTime>(&message)) {
    watch_.time(time->seconds, arrived_s, out.issues);
    finish(framing_.time(time->seconds, arrived_s), out);
    return;
  }
  framing_.other();
  if (const auto* const received = std::get_if<VmcBone>(&message)) {
    bone(*received, arrived_s, out);
  } else if (const auto* const root = std::get_if<VmcRoot>(&message)) {
    pose_.root_position = root->world.position;
    if (root->world.rotation) pose_.root_rotation = *root->world.rotation;
    scale_ = root->scale;
  } else if (const auto* const ok = std::get_if<VmcOk>(&message)) {
    watch_.ok(*ok, arrived_s);
  } else if (const auto* const model = std::get_if<VmcModel>(&message)) {
    title_ = model->title.substr(0, longest_name);
  } else if (const auto* const end = std::get_if<VmcEnd>(&message)) {
    if (const auto known = humanoid_bone(end->bone)) pose_.end[static_cast<std::size_t>(*known)] = end->local;
  }
}

/// VRM 1 calls the thumb's bones metacarpal, proximal, distal; VRM 0 proximal, intermediate, distal.
std::optional<int> VmcPerformer::bone_named(const std::string& name) {
  constexpr std::string_view metacarpal = "ThumbMetacarpal", proximal = "ThumbProximal";
  if (name.ends_with(metacarpal)) {
    has_vrm1_thumbs_ = true;
    return humanoid_bone(name.substr(0, name.size() - metacarpal.size()) + "ThumbProximal");
  }
  if (has_vrm1_thumbs_ && name.ends_with(proximal))
    return humanoid_bone(name.substr(0, name.size() - proximal.size()) + "ThumbIntermediate");
  return humanoid_bone(name);
}

void VmcPerformer::bone(const VmcBone& received, double arrived_s, Decoded& out) {
  if (received.name == "LastBone") return;  // the end of Unity's enumeration, not a bone
  const auto known = bone_named(received.name);
  if (!known) {
    const std::string name = received.name.substr(0, longest_name);
    if (unknown_bones_.size() < most_unknown_bones) unknown_bones_.insert(name);
    out.issues.push_back({"unknown-bone", name_ + ": there is no bone '" + name +
                                              "' among Unity's humanoid bones; it is left out"});
    return;
  }
  finish(framing_.bone(*known, arrived_s), out);
  const auto b = static_cast<std::size_t>(*known);
  pose_.position[b] = received.local.position;
  if (!received.local.rotation) return;
  pose_.rotation[b] = *received.local.rotation;
  pose_.present[b] = true;
  watch_.bone(*known, received.local, arrived_s);
}

/// SlimeVR and others send bones that nothing tracks at their parent's place, without a turn.
HumanoidPose VmcPerformer::tracked_pose() const {
  constexpr double no_place_m = 1e-6, no_turn_rad = 1e-6;
  HumanoidPose pose = pose_;
  if (pose.lacks_offsets()) return pose;  // then no bone has a place
  for (int bone = humanoid::Hips + 1; bone < humanoid::bone_count; ++bone) {
    const auto b = static_cast<std::size_t>(bone);
    const bool is_idle = pose.position[b].norm() < no_place_m &&
                         pose.rotation[b].angularDistance(Eigen::Quaterniond::Identity()) < no_turn_rad;
    pose.present[b] = pose.present[b] && !is_idle;
  }
  return pose;
}

void VmcPerformer::finish(const std::optional<VmcFraming::Frame>& frame, Decoded& out) {
  if (!frame) return;
  watch_.frame();
  const HumanoidPose pose = tracked_pose();
  std::string missing;
  for (const int bone : humanoid::required)
    if (!pose.present[static_cast<std::size_t>(bone)])
      missing += (missing.empty() ? "" : ", ") + humanoid_bone_name(bone);
  if (!missing.empty()) {
    const bool lacks_legs_alone = std::ranges::all_of(humanoid::required, [&](int bone) {
      return pose.present[static_cast<std::size_t>(bone)] ||
             (bone >= humanoid::LeftUpperLeg && bone <= humanoid::RightToes);
    });
    out.issues.push_back(
        {"missing-bones",
         name_ + (lacks_legs_alone ? ": bones come, but no legs: no pose without " : ": no pose without ") +
             missing});
    return;
  }
  if (framing_.is_time_inside() && frame->arrived_s - told_inside_s_ >= 1) {
    told_inside_s_ = frame->arrived_s;
    out.issues.push_back({"time-inside-frame", name_ + ": T comes between the bones of a frame, as from "
                                                       "another timer; frames end as without it. Have T "
                                                       "sent before or behind all bones"});
  }
  if (frame->held > 0)
    out.issues.push_back({"incomplete-frame", name_ + ": " + std::to_string(frame->held) +
                                                  " bones of the frame before did not come; they are held"});
  if (calibrate_next_) points_.calibrate(pose);
  calibrate_next_ = false;
  ++frames_;
  PerformerFrame done;
  done.performer = name_;
  done.points = points_.names(pose);
  done.positions = points_.positions(pose);
  done.sender_time_s = frame->time;
  done.first_arrived_s = frame->first_arrived_s;
  done.arrived_s = frame->arrived_s;
  out.frames.push_back(std::move(done));
}

void VmcPerformer::pass_time(double now_s, Decoded& out) {
  finish(framing_.silence(now_s), out);
  watch_.pass_time(now_s, out.issues);
}

void VmcPerformer::calibrate() {
  if (frames_ > 0)
    points_.calibrate(tracked_pose());
  else
    calibrate_next_ = true;
}

std::string VmcPerformer::facts() const {
  const HumanoidPose pose = tracked_pose();
  const auto bones = std::count(pose.present.begin(), pose.present.end(), true);
  const auto idle = std::count(pose_.present.begin(), pose_.present.end(), true) - bones;
  std::string facts = name_ + ": " + std::to_string(bones) + " bones";
  if (idle > 0) facts += ", " + std::to_string(idle) + " more at their parent's place are left out";
  if (bones > 0 && pose_.lacks_offsets()) facts += ", no offsets: an average body's are used";
  if (points_.is_calibrated())
    facts += ", calibrated";
  else if (bones > 0 && !HumanoidPoints::has_upright_rest(pose_))
    facts += ", rest rotations are not those of a T-pose: calibrate";
  if (frames_ > 0) facts += framing_.is_time_first() ? ", T first" : ", T last or none";
  if (!(scale_ - Vec3::Ones()).isZero(1e-6)) facts += ", has a root scale (not applied)";
  if (!title_.empty()) facts += ", avatar '" + title_ + "'";
  if (!unknown_bones_.empty()) facts += ", " + std::to_string(unknown_bones_.size()) + " unknown bones";
  if (const auto& ok = watch_.last_ok()) {
    if (ok->loaded == 0) facts += ", no avatar loaded";
    if (ok->calibration != 3) facts += ", not calibrated by its own account";
    if (ok->tracking == 0) facts += ", tracking is bad by its own account";
  }
  return facts;
}

}  // namespace abrazo
