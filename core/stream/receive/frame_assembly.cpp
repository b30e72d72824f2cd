#include "core/stream/receive/frame_assembly.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/base/text.hpp"
#include "core/motion/body/person_bounds.hpp"

namespace abrazo {

namespace {

std::string performer_name(int joint) {
  return std::string(joint_names[static_cast<std::size_t>(joint)]);
}

std::string names_of(const std::array<bool, joint_count>& chosen) {
  std::string names;
  for (int j = 0; j < joint_count; ++j)
    if (chosen[static_cast<std::size_t>(j)]) names += (names.empty() ? "" : ", ") + performer_name(j);
  return names;
}

bool is_believable(const Vec3& position) {
  return position.allFinite() && position.cwiseAbs().maxCoeff() < person_bounds::farthest_m;
}

std::string why_no_map_fits(const JointMap& closest, const JointBinding& binding, std::size_t points) {
  std::string text = "no joints from " + std::to_string(points) + " points: the closest joint map, '" +
                     closest.name + "', lacks ";
  constexpr std::size_t most = 5;
  for (std::size_t i = 0; i < binding.missing.size() && i < most; ++i)
    text += (i > 0 ? ", " : "") + describe_joint(closest, binding.missing[i]);
  if (binding.missing.size() > most)
    text += " and " + std::to_string(binding.missing.size() - most) + " more";
  return text + "; have the sender stream the whole body, or name the points in a joint map (map=FILE.json)";
}

}  // namespace

Vec3 StreamCorrection::apply(const Vec3& position) const {
  const Vec3 metres = metres_per_unit * position;
  const Vec3 y_up = z_up ? Vec3(metres.x(), metres.z(), -metres.y()) : metres;
  return y_up - Vec3(0, floor_y_m, 0);
}

std::string StreamCorrection::text() const {
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (metres_per_unit != 1) add("unit " + exact_text(metres_per_unit) + " m");
  if (z_up) add("Z up");
  if (floor_y_m != 0) {
    char shift[32];
    std::snprintf(shift, sizeof shift, "floor %+.3f m", -floor_y_m);
    add(shift);
  }
  return text;
}

void FrameAssembly::bind(const std::shared_ptr<const std::vector<std::string>>& points) {
  points_ = points;
  binding_.reset();
  map_name_.clear();
  estimated_.clear();
  const std::vector<JointMap> given =
      options_.joint_map ? std::vector<JointMap>{*options_.joint_map} : std::vector<JointMap>{};
  const std::vector<JointMap>& maps = options_.joint_map ? given : builtin_joint_maps();
  const JointMap* closest = nullptr;
  JointBinding best;
  for (const JointMap& map : maps) {
    JointBinding binding = bind_joints(map, *points);
    if (closest && binding.missing.size() >= best.missing.size()) continue;
    closest = &map;
    best = std::move(binding);
    if (best.missing.empty()) break;
  }
  if (!best.missing.empty()) {
    why_not_bound_ = why_no_map_fits(*closest, best, points->size());
    return;
  }
  map_name_ = closest->name;
  for (const int joint : best.estimated) estimated_.push_back(performer_name(joint));
  binding_ = std::move(best);
}

FrameAssembly::Assembled FrameAssembly::assemble(const PerformerFrame& frame) {
  if (!frame.points || frame.positions.rows() != static_cast<Eigen::Index>(frame.points->size()))
    return {{}, 0, StreamIssue{"malformed-frame", "a frame has not one position for each point"}};
  if (frame.points != points_) bind(frame.points);
  if (!binding_) return {{}, 0, StreamIssue{"no-joint-map", why_not_bound_}};
  Pose pose = binding_->joints_of(frame.positions);
  std::array<bool, joint_count> missing{};
  for (int j = 0; j < joint_count; ++j) {
    const Vec3 corrected = options_.correction.apply(pose.row(j).transpose());
    pose.row(j) = corrected.transpose();
    missing[static_cast<std::size_t>(j)] = !is_believable(corrected);
  }
  return fill_missing(std::move(pose), missing, frame.arrived_s);
}

FrameAssembly::Assembled FrameAssembly::fill_missing(Pose pose, const std::array<bool, joint_count>& missing,
                                                     double time_s) {
  const auto count = static_cast<int>(std::count(missing.begin(), missing.end(), true));
  if (missing[joints::Root])
    return {
        {}, 0, StreamIssue{"root-missing", "the root (hips) is not tracked; without it there is no pose"}};
  if (count > most_missing)
    return {{},
            0,
            StreamIssue{"joints-missing", std::to_string(count) + " of 25 joints are not tracked (" +
                                              names_of(missing) + "); at most " +
                                              std::to_string(most_missing) + " can be held"}};
  for (int j = 1; j < joint_count; ++j) {
    const auto at = static_cast<std::size_t>(j);
    if (!missing[at]) continue;
    if (!previous_ || time_s - tracked_s_[at] > options_.longest_hold_s)
      return {{},
              0,
              StreamIssue{"joints-missing",
                          performer_name(j) + " has not been tracked for longer than the " +
                              exact_text(options_.longest_hold_s) +
                              " s that a joint is held; show its markers, or set hold=" + "MILLISECONDS"}};
    // A parent comes before its children, so its place is known by now.
    const int parent = joint_parents[at];
    pose.row(j) = pose.row(parent) + previous_->row(j) - previous_->row(parent);
  }
  for (std::size_t j = 0; j < joint_count; ++j)
    if (!missing[j]) tracked_s_[j] = time_s;
  previous_ = pose;
  Assembled assembled{pose, count, {}};
  if (count > 0)
    assembled.issue =
        StreamIssue{"held-joints", "not tracked, held from the frame before: " + names_of(missing)};
  return assembled;
}

}  // namespace abrazo
