#include "core/stream/xsens/xsens_character.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.hpp"
#include "core/stream/protocol/sent_rotation.hpp"

namespace abrazo {

namespace {

constexpr std::size_t most_partials = 4;
constexpr double other_type_after_s = 1;

constexpr int pelvis_segment = 0, t8_segment = 4, head_segment = 6;

/// A segment that has nothing behind it. With the scale its last point is known: that whose name holds
/// `point`.
struct SegmentEnd {
  int before, last;
  double fraction;
  bool level;
  std::string_view point;
};
constexpr std::array<SegmentEnd, 5> segment_ends = {
    SegmentEnd{5, 6, crown_beyond_neck_length, false, "topofhead"},
    SegmentEnd{9, 10, hand_beyond_forearm_length, false, "topofhand"},
    SegmentEnd{13, 14, hand_beyond_forearm_length, false, "topofhand"},
    SegmentEnd{17, 18, toes_beyond_foot_length, true, "toe"},
    SegmentEnd{21, 22, toes_beyond_foot_length, true, "toe"}};

/// MVN's axes, x forward and z up, to y up and z forward.
Vec3 mvn_to_y_up(const Vec3& v) {
  return {v.y(), v.z(), v.x()};
}

/// Metres per unit: a length that no person reaches in metres is in centimetres.
double unit_of(double length, double longest_m) {
  return length > longest_m ? 0.01 : 1.0;
}

/// How useful a type of pose datagram is: absolute positions with rotations first.
int rank_of(int type) {
  switch (static_cast<XsensType>(type)) {
    case XsensType::PoseQuaternion:
      return 3;
    case XsensType::PoseEuler:
      return 2;
    default:
      return 1;
  }
}

std::string two_digits(int type) {
  return {static_cast<char>('0' + type / 10 % 10), static_cast<char>('0' + type % 10)};
}

/// The rotation with Y up; not finite if there is none.
Eigen::Quaterniond turned(const Eigen::Quaterniond& q, const Vec3& vector_part) {
  return {q.w(), vector_part.x(), vector_part.y(), vector_part.z()};
}

std::shared_ptr<const std::vector<std::string>> point_names(bool with_ends) {
  std::vector<std::string> names(xsens_segment_names.begin(), xsens_segment_names.end());
  if (with_ends)
    for (const SegmentEnd& end : segment_ends)
      names.push_back(names[static_cast<std::size_t>(end.last)] + "_End");
  return std::make_shared<const std::vector<std::string>>(std::move(names));
}

}  // namespace

std::int64_t SampleSteps::number_of(std::uint32_t sample) {
  if (!last_) {
    last_ = sample;
    return number_ = sample;
  }
  // Unsigned difference, so that the counter may run over its end.
  const auto step = static_cast<std::int64_t>(static_cast<std::int32_t>(sample - *last_));
  constexpr std::int64_t restart = 1000;
  if (std::abs(step) > restart) {
    step_ = 0;
    number_ = sample;
  } else if (step > 0) {
    step_ = step_ == 0 ? step : std::min(step_, step);
    number_ +=
        std::max<std::int64_t>(1, std::llround(static_cast<double>(step) / static_cast<double>(step_)));
  } else if (step < 0) {
    return number_ + step / std::max<std::int64_t>(1, step_);  // an older one; the newest stays
  }
  last_ = sample;
  return number_;
}

void XsensCharacter::take_meta(const XsensMeta& meta) {
  if (!meta.name.empty()) name_ = meta.name;
}

void XsensCharacter::take_scale(const XsensScale& scale) {
  constexpr double tallest_m = 3, longest_segment_m = 1.5;
  double highest = 0;
  for (const auto& [name, origin] : scale.segments) highest = std::max(highest, std::abs(origin.z()));
  for (const auto& [name, origin] : scale.segments)
    for (std::size_t s = 0; s < xsens_segment_names.size(); ++s) {
      std::string plain;
      for (const char c : name)
        if (c != ' ') plain += c;
      if (lower_case(plain) == lower_case(xsens_segment_names[s]) && origin.allFinite())
        rest_origins_[s] = unit_of(highest, tallest_m) * mvn_to_y_up(origin);
    }
  for (const XsensPoint& point : scale.points)
    for (std::size_t e = 0; e < segment_ends.size(); ++e) {
      const std::string name = lower_case(point.name);
      const bool is_joint = name.starts_with('j');
      if (point.segment != segment_ends[e].last + 1 || is_joint || !point.offset.allFinite() ||
          name.find(segment_ends[e].point) == std::string::npos)
        continue;
      end_offsets_[e] = unit_of(point.offset.norm(), longest_segment_m) * mvn_to_y_up(point.offset);
    }
}

/// Whether the datagram is of the type that is used, when a sender has ticked several.
bool XsensCharacter::is_chosen(const XsensHeader& header, double arrived_s, Decoded& out) {
  const bool is_better = !type_ || *type_ == header.type || rank_of(header.type) > rank_of(*type_) ||
                         arrived_s - type_s_ > other_type_after_s;
  if (!is_better) {
    out.issues.push_back(
        {"other-pose-type", "pose datagrams of type " + two_digits(header.type) +
                                " come beside those of type " + two_digits(*type_) +
                                ", which are used; untick the former in the network streamer"});
    return false;
  }
  if (type_ != header.type) partials_.clear();
  type_ = header.type;
  type_s_ = arrived_s;
  return true;
}

void XsensCharacter::take_pose(const XsensHeader& header, const std::vector<XsensSegment>& segments,
                               double arrived_s, Decoded& out) {
  if (!is_chosen(header, arrived_s, out)) return;
  finger_segments_ = header.finger_segments;
  Partial datagram{header, arrived_s, {}, {}};
  for (const XsensSegment& segment : segments)
    if (const auto index = xsens_body_segment(segment.number, static_cast<XsensType>(header.type))) {
      datagram.segments[static_cast<std::size_t>(*index)] = segment;
      datagram.have.set(static_cast<std::size_t>(*index));
    }
  const auto wanted =
      static_cast<std::size_t>(std::clamp(header.body_segments, 1, static_cast<int>(xsens_segment_count)));
  const auto same = std::find_if(partials_.begin(), partials_.end(), [&](const Partial& partial) {
    return partial.header.sample == header.sample;
  });
  if (datagram.have.count() >= wanted) {
    if (same != partials_.end()) partials_.erase(same);
    return complete(datagram, arrived_s, out);
  }
  if (completed_sample_ == header.sample) return;  // the fingers of a body that went out
  if (same == partials_.end()) {
    partials_.push_back(datagram);
  } else {
    for (std::size_t s = 0; s < xsens_segment_count; ++s)
      if (datagram.have[s]) same->segments[s] = datagram.segments[s];
    same->have |= datagram.have;
    if (same->have.count() >= wanted) {
      const Partial whole = *same;
      partials_.erase(same);
      return complete(whole, arrived_s, out);
    }
  }
  if (partials_.size() > most_partials) {
    out.issues.push_back({"incomplete", "of sample " + std::to_string(partials_.front().header.sample) +
                                            " only " + std::to_string(partials_.front().have.count()) +
                                            " of " + std::to_string(wanted) + " segments arrived"});
    partials_.erase(partials_.begin());
  }
}

/// Of type 05: every segment relative to its parent.
void XsensCharacter::place_relative(Poses& poses, std::vector<StreamIssue>& issues) const {
  double lengths = 0;
  for (std::size_t s = 1; s < poses.size(); ++s) lengths += poses[s].position.norm();
  const bool has_offsets = !(lengths < 1e-3);
  const bool has_origins = std::all_of(rest_origins_.begin(), rest_origins_.end(),
                                       [](const auto& origin) { return origin.has_value(); });
  if (!has_offsets && !has_origins)
    issues.push_back({"no-offsets",
                      "type 05 comes without positions of the segments; tick Position + Orientation "
                      "(Quaternion) in the network streamer, or Scaling Data as well"});
  for (std::size_t s = 1; s < poses.size(); ++s) {
    const auto parent = static_cast<std::size_t>(xsens_parents[s]);
    const Vec3 offset =
        !has_offsets && has_origins ? Vec3(*rest_origins_[s] - *rest_origins_[parent]) : poses[s].position;
    poses[s].position = poses[parent].position + poses[parent].rotation * offset;
    poses[s].rotation = poses[parent].rotation * poses[s].rotation;
  }
}

/// In the rest pose all rotations are the identity, so the position of a segment in its parent's space is its
/// rest offset in any pose. From the pelvis to the head it points upwards.
std::optional<char> XsensCharacter::up_of_spine(const Poses& poses) const {
  Vec3 rest = Vec3::Zero();
  for (int s = head_segment; s != pelvis_segment; s = xsens_parents[static_cast<std::size_t>(s)]) {
    const SegmentPose& below = poses[static_cast<std::size_t>(xsens_parents[static_cast<std::size_t>(s)])];
    rest += below.rotation.conjugate() * Vec3(poses[static_cast<std::size_t>(s)].position - below.position);
  }
  if (!rest.allFinite() || rest.norm() < 1e-3) return std::nullopt;
  if (std::abs(rest.z()) > 2 * std::max(std::abs(rest.x()), std::abs(rest.y()))) return 'z';
  if (std::abs(rest.y()) > 2 * std::max(std::abs(rest.x()), std::abs(rest.z()))) return 'y';
  return std::nullopt;
}

/// By the length of the trunk, which is the same in every pose.
void XsensCharacter::find_unit(const Poses& poses, std::vector<StreamIssue>& issues) {
  if (given_.metres_per_unit) {
    metres_per_unit_ = *given_.metres_per_unit;
    return;
  }
  constexpr double longest_trunk_m = 3;
  const double trunk = (poses[t8_segment].position - poses[pelvis_segment].position).norm();
  if (!std::isfinite(trunk)) {
    if (metres_per_unit_ == 0) metres_per_unit_ = 1;
    return;
  }
  const double found = unit_of(trunk, longest_trunk_m);
  if (metres_per_unit_ != 0 && found != metres_per_unit_)
    issues.push_back({"unit-changed", "positions were in " +
                                          std::string(found == 1 ? "cm and are in m" : "m and are in cm") +
                                          " now; option units=m|cm decides it"});
  metres_per_unit_ = found;
}

Vec3 XsensCharacter::end_of(const Poses& poses, std::size_t end) const {
  const SegmentEnd& rule = segment_ends[end];
  const SegmentPose& last = poses[static_cast<std::size_t>(rule.last)];
  if (end_offsets_[end]) return last.position + last.rotation * *end_offsets_[end];
  return limb_end(poses[static_cast<std::size_t>(rule.before)], last, rule.fraction, rule.level);
}

void XsensCharacter::complete(const Partial& sample, double arrived_s, Decoded& out) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto type = static_cast<XsensType>(sample.header.type);
  completed_sample_ = sample.header.sample;
  Poses poses;
  bool is_finite = true;
  for (std::size_t s = 0; s < poses.size(); ++s) {
    const XsensSegment& segment = sample.segments[s];
    poses[s].position = sample.have[s] ? segment.position : Vec3::Constant(nan);
    is_finite = is_finite && (!sample.have[s] || segment.position.allFinite());
    if (!poses[s].position.allFinite()) poses[s].position = Vec3::Constant(nan);
    poses[s].rotation = segment.rotation && is_rotation(*segment.rotation)
                            ? segment.rotation->normalized()
                            : Eigen::Quaterniond(nan, nan, nan, nan);
  }
  if (!is_finite)
    out.issues.push_back({"not-finite", "sample " + std::to_string(sample.header.sample) +
                                            " has positions that are not finite"});
  if (type == XsensType::PoseUnity) {
    for (SegmentPose& pose : poses) {  // left-handed, Y up: mirrored at x
      pose.position.x() = -pose.position.x();
      pose.rotation = turned(pose.rotation, Vec3(pose.rotation.x(), -pose.rotation.y(), -pose.rotation.z()));
    }
    place_relative(poses, out.issues);
  } else if (type == XsensType::PoseQuaternion) {
    if (!up_) up_ = up_of_spine(poses);
    if (up_.value_or('z') == 'z')
      for (SegmentPose& pose : poses) {
        pose.position = mvn_to_y_up(pose.position);
        pose.rotation = turned(pose.rotation, mvn_to_y_up(pose.rotation.vec()));
      }
  }
  find_unit(poses, out.issues);
  for (SegmentPose& pose : poses) pose.position *= metres_per_unit_;

  const bool has_rotations = type != XsensType::PoseEuler;
  auto& names = has_rotations ? points_ : points_without_ends_;
  if (!names) names = point_names(has_rotations);
  PerformerFrame frame;
  if (performer_.empty()) performer_ = name_.empty() ? "character " + std::to_string(id_ + 1) : name_;
  frame.performer = performer_;
  if (name_ != performer_) frame.also_called = name_;
  frame.points = names;
  frame.positions.resize(static_cast<Eigen::Index>(names->size()), 3);
  for (std::size_t s = 0; s < poses.size(); ++s)
    frame.positions.row(static_cast<Eigen::Index>(s)) = poses[s].position.transpose();
  if (has_rotations)
    for (std::size_t e = 0; e < segment_ends.size(); ++e)
      frame.positions.row(static_cast<Eigen::Index>(xsens_segment_count + e)) = end_of(poses, e).transpose();
  frame.counter = steps_.number_of(sample.header.sample);
  frame.sender_time_s = sample.header.time_ms / 1000.0;
  frame.first_arrived_s = sample.first_arrived_s;
  frame.arrived_s = arrived_s;
  out.frames.push_back(std::move(frame));
}

std::string XsensCharacter::fact() const {
  std::string text = "character " + std::to_string(id_ + 1);
  if (!name_.empty()) text += " (" + name_ + ")";
  if (type_) text += ": type " + two_digits(*type_);
  if (metres_per_unit_ != 0)
    text += std::string(", positions in ") + (metres_per_unit_ == 1 ? "m" : "cm") +
            (given_.metres_per_unit ? " (as set)" : " (found from the data; option units=m|cm)");
  if (type_ == static_cast<int>(XsensType::PoseQuaternion))
    text += up_.value_or('z') == 'z' ? ", Z up" : ", Y up";
  if (finger_segments_ > 0) text += ", " + std::to_string(finger_segments_) + " finger segments";
  if (type_ == static_cast<int>(XsensType::PoseEuler))
    text +=
        ", ends of head, hands and toes estimated: tick Position + Orientation (Quaternion) for better ones";
  else if (std::any_of(end_offsets_.begin(), end_offsets_.end(),
                       [](const auto& end) { return end.has_value(); }))
    text += ", ends of limbs by the sender's scaling data";
  else
    text += ", ends of limbs estimated: tick Scaling Data for measured ones";
  return text;
}

}  // namespace abrazo
