#include "core/stream/vmc/vmc_encoder.hpp"

#include <cmath>
#include <vector>

#include "core/base/text.hpp"
#include "core/stream/humanoid/joints_to_humanoid.hpp"
#include "core/stream/vmc/osc_packet.hpp"
#include "core/stream/vmc/vmc_message.hpp"

namespace abrazo {

namespace {

/// As many bones as the VMC application puts into a bundle; strict receivers have room for no more.
constexpr std::size_t bones_per_bundle = 12;

using Packet = std::vector<std::uint8_t>;

/// The crown above the head's middle: the 25 joints have the middle, humanoids the crown; see the joint map
/// "unity".
constexpr double middle_of_head = 0.6;

class VmcEncoder : public StreamEncoder {
 public:
  VmcEncoder(const Body& body, bool time_first) : humanoid_(body), time_first_(time_first) {}

  std::vector<Packet> packets(const OutgoingPose& pose) override {
    if (!start_s_) start_s_ = pose.time_s;
    const HumanoidPose humanoid = humanoid_.pose(pose.pose, pose.time_s);
    const OscElement time =
        osc_message("/VMC/Ext/T", {OscArgument::of(static_cast<float>(pose.time_s - *start_s_))});
    return time_first_ ? one_bundle(humanoid, pose.tracked, time)
                       : several_bundles(humanoid, pose.tracked, time);
  }

  void set_body(const Body& body) override { humanoid_ = JointsToHumanoid(body); }

  void restart() override {
    humanoid_.restart();
    start_s_.reset();
  }

 private:
  /// Loaded, calibrated, normal mode; tracking as it is.
  static OscElement ok(bool tracked) {
    return osc_message("/VMC/Ext/OK", {OscArgument::of(1), OscArgument::of(3), OscArgument::of(0),
                                       OscArgument::of(tracked ? 1 : 0)});
  }

  static std::vector<OscElement> bones_of(const HumanoidPose& humanoid) {
    std::vector<OscElement> messages;
    for (int bone = 0; bone < humanoid::bone_count; ++bone) {
      const auto b = static_cast<std::size_t>(bone);
      if (humanoid.present[b])
        messages.push_back(
            vmc_bone_message(humanoid_bone_name(bone), humanoid.position[b], humanoid.rotation[b]));
    }
    return messages;
  }

  static void add_ends(const HumanoidPose& humanoid, std::vector<OscElement>& bundle) {
    for (int bone = 0; bone < humanoid::bone_count; ++bone)
      if (const auto& end = humanoid.end[static_cast<std::size_t>(bone)]) {
        const double share = bone == humanoid::Head ? middle_of_head : 1.0;
        bundle.push_back(vmc_end_message(humanoid_bone_name(bone), *end / share));
      }
  }

  static std::vector<Packet> several_bundles(const HumanoidPose& humanoid, bool tracked,
                                             const OscElement& time) {
    const std::vector<OscElement> bones = bones_of(humanoid);
    std::vector<Packet> packets;
    std::size_t next = 0;
    for (; bones.size() - next > bones_per_bundle; next += bones_per_bundle) {
      std::vector<OscElement> bundle = {osc_bundle_begin()};
      for (std::size_t b = next; b < next + bones_per_bundle; ++b) bundle.push_back(bones[b]);
      bundle.push_back(osc_bundle_end());
      packets.push_back(write_osc(bundle));
    }
    std::vector<OscElement> last = {osc_bundle_begin(),
                                    vmc_root_message(humanoid.root_position, humanoid.root_rotation)};
    for (; next < bones.size(); ++next) last.push_back(bones[next]);
    add_ends(humanoid, last);
    last.push_back(ok(tracked));
    last.push_back(time);
    last.push_back(osc_bundle_end());
    packets.push_back(write_osc(last));
    return packets;
  }

  static std::vector<Packet> one_bundle(const HumanoidPose& humanoid, bool tracked, const OscElement& time) {
    std::vector<OscElement> bundle = {osc_bundle_begin(), time, ok(tracked),
                                      vmc_root_message(humanoid.root_position, humanoid.root_rotation)};
    for (const OscElement& bone : bones_of(humanoid)) bundle.push_back(bone);
    add_ends(humanoid, bundle);
    bundle.push_back(osc_bundle_end());
    return {write_osc(bundle)};
  }

  JointsToHumanoid humanoid_;
  bool time_first_;
  std::optional<double> start_s_;
};

}  // namespace

Result<std::unique_ptr<StreamEncoder>> make_vmc_encoder(const StreamUri& uri, const Body& body) {
  const std::string framing = uri.option("framing", "t-last");
  if (framing != "t-last" && framing != "t-first")
    return Error{
        "the option \"framing\" is " + in_quotes(framing) +
            "; expected t-last (several bundles, as the VMC application) or t-first (one, as SlimeVR)",
        uri.text};
  for (const double length : body.bone_lengths)
    if (!std::isfinite(length) || length < 0 || length > 10)
      return Error{"a bone of the character is " + exact_text(length) + " m long; its body was not measured",
                   uri.text};
  return std::unique_ptr<StreamEncoder>(std::make_unique<VmcEncoder>(body, framing == "t-first"));
}

}  // namespace abrazo
