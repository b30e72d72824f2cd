#include "core/stream/vmc/vmc_encoder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/text.hpp"
#include "core/stream/humanoid/joints_to_humanoid.hpp"
#include "core/stream/vmc/osc_packet.hpp"
#include "core/stream/vmc/vmc_message.hpp"

namespace abrazo {

namespace {

/// As many bones as the VMC application puts into a bundle; strict receivers have room for no more.
constexpr std::size_t bones_per_bundle = 12;

/// Of the hips' forward direction, so much has to be level for a heading.
constexpr double least_level = 0.2;

using Packet = std::vector<std::uint8_t>;

/// The crown above the head's middle: the 25 joints have the middle, humanoids the crown; see the joint map
/// "unity".
constexpr double middle_of_head = 0.6;

enum class VmcFrames { TimeLast, TimeFirst, Split };

class VmcEncoder : public StreamEncoder {
 public:
  VmcEncoder(const Body& body, VmcFrames frames, bool has_place_in_root)
      : humanoid_(body), frames_(frames), has_place_in_root_(has_place_in_root) {}

  std::vector<Packet> packets(const OutgoingPose& pose) override {
    if (!start_s_) start_s_ = pose.time_s;
    HumanoidPose humanoid = humanoid_.pose(pose.pose, pose.time_s);
    if (has_place_in_root_) put_place_into_root(humanoid);
    const OscElement time =
        osc_message("/VMC/Ext/T", {OscArgument::of(static_cast<float>(pose.time_s - *start_s_))});
    return frames_ == VmcFrames::Split ? several_bundles(humanoid, pose.tracked, time)
                                       : one_bundle(humanoid, pose.tracked, time);
  }

  void set_body(const Body& body) override { humanoid_ = JointsToHumanoid(body); }

  void restart() override {
    humanoid_.restart();
    start_s_.reset();
    heading_ = Eigen::Quaterniond::Identity();
  }

 private:
  /// The root stands on the floor below the hips and turns with them about the vertical; the hips are
  /// relative to it.
  void put_place_into_root(HumanoidPose& humanoid) {
    constexpr auto hips = static_cast<std::size_t>(humanoid::Hips);
    const Vec3 forward = humanoid.rotation[hips] * Vec3::UnitZ();
    // Somebody who bends down by a right angle has no heading: the last one stays.
    if (std::hypot(forward.x(), forward.z()) > least_level)
      heading_ = Eigen::AngleAxisd(std::atan2(forward.x(), forward.z()), Vec3::UnitY());
    const Vec3 place = humanoid.position[hips];
    humanoid.root_position = Vec3(place.x(), 0, place.z());
    humanoid.root_rotation = heading_;
    humanoid.position[hips] = Vec3(0, place.y(), 0);
    humanoid.rotation[hips] = heading_.conjugate() * humanoid.rotation[hips];
  }

  /// Loaded, calibrated, normal mode; tracking as it is.
  static OscElement ok(bool tracked) {
    return osc_message("/VMC/Ext/OK", {OscArgument::of(1), OscArgument::of(3), OscArgument::of(0),
                                       OscArgument::of(tracked ? 1 : 0)});
  }
  /// Some receivers show a frame only when they are told to apply its expressions, of which there are none.
  static OscElement apply() { return osc_message("/VMC/Ext/Blend/Apply", {}); }

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
    for (const OscElement& end : {apply(), ok(tracked), time, osc_bundle_end()}) last.push_back(end);
    packets.push_back(write_osc(last));
    return packets;
  }

  std::vector<Packet> one_bundle(const HumanoidPose& humanoid, bool tracked, const OscElement& time) const {
    const bool time_first = frames_ == VmcFrames::TimeFirst;
    std::vector<OscElement> bundle = {osc_bundle_begin()};
    if (time_first) bundle.insert(bundle.end(), {time, ok(tracked)});
    bundle.push_back(vmc_root_message(humanoid.root_position, humanoid.root_rotation));
    for (const OscElement& bone : bones_of(humanoid)) bundle.push_back(bone);
    add_ends(humanoid, bundle);
    bundle.push_back(apply());
    if (!time_first) bundle.insert(bundle.end(), {ok(tracked), time});
    bundle.push_back(osc_bundle_end());
    return {write_osc(bundle)};
  }

  JointsToHumanoid humanoid_;
  VmcFrames frames_;
  bool has_place_in_root_;
  Eigen::Quaterniond heading_ = Eigen::Quaterniond::Identity();
  std::optional<double> start_s_;
};

/// @return which of the words the option is, in their order; the first if it is not given
Result<std::size_t> choice(const StreamUri& uri, std::string_view option,
                           std::span<const std::string_view> words, std::string_view meaning) {
  const std::string value = uri.option(option, words.front());
  const auto found = std::ranges::find(words, value);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  return Error{
      "the option " + in_quotes(option) + " is " + in_quotes(value) + "; expected " + std::string(meaning),
      uri.text};
}

}  // namespace

Result<std::unique_ptr<StreamEncoder>> make_vmc_encoder(const StreamUri& uri, const Body& body) {
  constexpr std::array<std::string_view, 3> framings = {"t-last", "t-first", "split"};
  constexpr std::array<std::string_view, 2> roots = {"character", "origin"};
  const auto framing =
      choice(uri, "framing", framings,
             "t-last (one bundle that ends with T), t-first (one that begins with it, as SlimeVR) or "
             "split (several of at most 12 bones, as the VMC application)");
  if (!framing) return framing.error();
  const auto root =
      choice(uri, "root", roots,
             "character (the place and heading of the character) or origin (both are in the hips)");
  if (!root) return root.error();
  for (const double length : body.bone_lengths)
    if (!std::isfinite(length) || length < 0 || length > 10)
      return Error{"a bone of the character is " + exact_text(length) + " m long; its body was not measured",
                   uri.text};
  return std::unique_ptr<StreamEncoder>(
      std::make_unique<VmcEncoder>(body, static_cast<VmcFrames>(*framing), *root == 0));
}

}  // namespace abrazo
