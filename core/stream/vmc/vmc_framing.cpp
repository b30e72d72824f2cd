#include "core/stream/vmc/vmc_framing.hpp"

namespace abrazo {

namespace {

/// T and the first bone of its frame are sent together; a T that is older ended the frame before.
constexpr double together_s = 0.003;

/// Number of packets for which a frame with missing bones may continue after a repeated bone: packets were
/// duplicated or late, the sender does not have fewer bones.
constexpr int most_put_off = 2;

}  // namespace

VmcFraming::Frame VmcFraming::close() {
  Frame frame{frame_time_ ? frame_time_ : inner_time_, first_arrived_s_, last_arrived_s_,
              static_cast<int>((usual_ & ~seen_).count())};
  time_first_ = frame_time_.has_value();
  usual_ = seen_;
  seen_.reset();
  frame_time_.reset();
  inner_time_.reset();
  put_off_ = 0;
  return frame;
}

std::optional<VmcFraming::Frame> VmcFraming::bone(int bone, double arrived_s) {
  other();
  const auto b = static_cast<std::size_t>(bone);
  std::optional<Frame> closed;
  if (last_inside_s_) inside_ = arrived_s - *last_inside_s_ < together_s ? inside_ + 1 : 0;
  last_inside_s_.reset();
  if (seen_.test(b)) {
    const bool lacks_bones = (usual_ & ~seen_).any();
    if (lacks_bones && !put_off_in_packet_ && put_off_ < most_put_off) {
      put_off_in_packet_ = true;
      ++put_off_;
      ++mixed_;
    } else if (!lacks_bones || !put_off_in_packet_) {
      closed = close();
    }
  }
  if (seen_.none()) {
    first_arrived_s_ = arrived_s;
    if (frame_time_ && arrived_s - frame_time_arrived_s_ > together_s) frame_time_.reset();
    if (frame_time_) first_arrived_s_ = frame_time_arrived_s_;
  }
  seen_.set(b);
  last_arrived_s_ = arrived_s;
  return closed;
}

std::optional<VmcFraming::Frame> VmcFraming::time(double value, double arrived_s) {
  if (!bundles_.empty() && bundles_.back() == 0) bundles_.back() = 1;
  const bool is_new = last_time_ != value;
  last_time_ = value;
  std::optional<Frame> closed;
  if (is_open()) {
    if (!is_new) return closed;
    const bool began_with_time = frame_time_.has_value();
    if (!began_with_time) last_inside_s_ = arrived_s;
    if (!began_with_time && is_time_inside()) {
      inner_time_ = value;
      return closed;
    }
    if (!began_with_time) last_arrived_s_ = arrived_s;
    closed = close();
    if (!began_with_time) {
      closed->time = value;
      return closed;
    }
  }
  inside_ = 0;
  frame_time_ = value;
  frame_time_arrived_s_ = arrived_s;
  return closed;
}

void VmcFraming::bundle_begins() {
  other();
  bundles_.push_back(0);
}

void VmcFraming::other() {
  if (!bundles_.empty() && bundles_.back() == 0) bundles_.back() = 2;
}

std::optional<VmcFraming::Frame> VmcFraming::bundle_ends() {
  if (bundles_.empty()) return std::nullopt;
  const bool began_with_time = bundles_.back() == 1;
  bundles_.pop_back();
  if (began_with_time && is_open()) return close();
  return std::nullopt;
}

std::optional<VmcFraming::Frame> VmcFraming::silence(double now_s) {
  if (!is_open() || now_s - last_arrived_s_ < silence_s) return std::nullopt;
  if (last_inside_s_) inside_ = 0;  // no bone went on behind T: it came last
  return close();
}

}  // namespace abrazo
