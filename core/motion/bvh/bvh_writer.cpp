#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>

#include "core/base/positions.hpp"
#include "core/base/text.hpp"
#include "core/motion/body/joint_rotations.hpp"
#include "core/motion/body/joint_tree.hpp"
#include "core/motion/bvh/bvh.hpp"

namespace abrazo {

namespace {

using Rotation = Eigen::Matrix3d;
using namespace joints;

/// Length of the end site beyond a limb's last joint [m]: toes, crown, fingers.
double end_site_length_m(int joint) {
  return joint == Head ? 0.12 : joint == LeftHand || joint == RightHand ? 0.09 : 0.03;
}

using Node = JointTree::Node;

constexpr double degrees_per_radian = 180.0 / std::numbers::pi;

/// Angles z, x, y [deg] with R = Rz Rx Ry. y is computed from the rest after z, so at the pole (x = +-90
/// degrees), where only z + y or z - y is determined, the product is still R; z then keeps its value of the
/// previous frame.
Vec3 zxy_degrees(const Rotation& r, double z_before_degrees) {
  const double cos_x = std::hypot(r(0, 1), r(1, 1));
  constexpr double at_pole = 1e-6;  // the error in R when z is kept [rad]
  const double z = cos_x < at_pole ? z_before_degrees / degrees_per_radian : std::atan2(-r(0, 1), r(1, 1));
  const double x = std::atan2(r(2, 1), cos_x);
  const double y = std::atan2(std::cos(z) * r(0, 2) + std::sin(z) * r(1, 2),
                              std::cos(z) * r(0, 0) + std::sin(z) * r(1, 0));
  return Vec3(z, x, y) * degrees_per_radian;
}

/// The same rotation by the angles nearest to those of the frame before, so that curves do not jump by turns.
Vec3 continued(const Vec3& angles, const Vec3& before) {
  const auto nearest = [&](Vec3 candidate) {
    for (int i = 0; i < 3; ++i) candidate[i] -= 360.0 * std::round((candidate[i] - before[i]) / 360.0);
    return candidate;
  };
  const Vec3 direct = nearest(angles);
  const Vec3 flipped = nearest(Vec3(angles[0] + 180.0, 180.0 - angles[1], angles[2] + 180.0));
  return (flipped - before).squaredNorm() < (direct - before).squaredNorm() ? flipped : direct;
}

/// Six digits after the point: a millionth of a degree or of a unit. No exponents: several readers refuse
/// them.
void append_number(std::string& text, double value) {
  std::array<char, 64> buffer{};
  if (std::abs(value) < 5e-7) value = 0;
  const auto [end, failure] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, 6);
  text.append(buffer.data(), end);
}

void append_vector(std::string& text, const Vec3& vector) {
  for (int i = 0; i < 3; ++i) {
    text += i > 0 ? " " : "";
    append_number(text, vector[i]);
  }
}

void append_node(std::string& text, const std::vector<Node>& nodes, std::size_t index,
                 const std::string& prefix, double units_per_metre, int depth) {
  const Node& node = nodes[index];
  const std::string indent(static_cast<std::size_t>(depth) * 2, ' ');
  text += indent + (node.parent < 0 ? "ROOT " : "JOINT ") + prefix + node.name + "\n" + indent + "{\n" +
          indent + "  OFFSET ";
  append_vector(text, node.offset * units_per_metre);
  text += "\n" + indent +
          (node.parent < 0 ? "  CHANNELS 6 Xposition Yposition Zposition " : "  CHANNELS 3 ") +
          "Zrotation Xrotation Yrotation\n";
  for (const int child : node.children)
    append_node(text, nodes, static_cast<std::size_t>(child), prefix, units_per_metre, depth + 1);
  if (node.children.empty()) {
    text += indent + "  End Site\n" + indent + "  {\n" + indent + "    OFFSET ";
    append_vector(text, rest_direction(node.joint) * end_site_length_m(node.joint) * units_per_metre);
    text += "\n" + indent + "  }\n";
  }
  text += indent + "}\n";
}

/// One performer of the file: its tree and the angles last written.
struct Performer {
  const Clip& clip;
  JointTree tree;
  std::vector<Vec3> angles;
  std::vector<Rotation> world;
};

/// The values of all nodes for one frame, in file order.
void append_frame(std::string& text, Performer& performer, std::size_t frame, double units_per_metre) {
  const std::vector<Node>& nodes = performer.tree.nodes();
  const Pose& pose = performer.clip.poses[frame];
  performer.tree.rotations(pose, 1.0 / performer.clip.fps, performer.world);
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    if (nodes[n].parent < 0) {
      append_vector(text, joint_at(pose, Root) * units_per_metre);
      text += ' ';
    }
    const Rotation local =
        nodes[n].parent < 0
            ? performer.world[n]
            : Rotation(performer.world[static_cast<std::size_t>(nodes[n].parent)].transpose() *
                       performer.world[n]);
    performer.angles[n] = continued(zxy_degrees(local, performer.angles[n][0]), performer.angles[n]);
    append_vector(text, performer.angles[n]);
    text += n + 1 < nodes.size() ? " " : "";
  }
}

Status check(std::span<const Clip> clips, double units_per_metre) {
  if (clips.empty()) return Error{"there is no clip to write", ""};
  if (!(units_per_metre > 0) || !std::isfinite(units_per_metre))
    return Error{"units per metre must be above 0", ""};
  std::set<std::string> names;
  for (const Clip& clip : clips) {
    if (clip.poses.empty()) return Error{"has no frames", clip.name};
    if (clip.poses.size() != clips[0].poses.size() || std::abs(clip.fps - clips[0].fps) > 1e-9)
      return Error{
          "must have as many frames and the same rate as '" + clips[0].name + "' to stand in one BVH file",
          clip.name};
    if (!(clip.fps > 0) || !std::isfinite(clip.fps)) return Error{"has no frame rate", clip.name};
    if (clips.size() > 1 && (clip.name.empty() || !names.insert(clip.name).second))
      return Error{"clips in one BVH file need names that differ", clip.name};
    for (std::size_t f = 0; f < clip.poses.size(); ++f)
      if (!clip.poses[f].allFinite())
        return Error{"has a position that is not finite", clip.name + ": frame " + std::to_string(f)};
  }
  return Done{};
}

/// Blanks and braces in names break other readers.
std::string prefix_of(std::string name) {
  for (char& c : name)
    if (c == '{' || c == '}' || c == ' ' || c == '\t' || c == '\n' || c == '\r') c = '_';
  return name + ":";
}

}  // namespace

Result<std::string> write_bvh(std::span<const Clip> clips, double units_per_metre) {
  if (const Status checked = check(clips, units_per_metre); !checked) return checked.error();
  std::vector<Performer> performers;
  std::string text = "HIERARCHY\n";
  for (const Clip& clip : clips) {
    performers.push_back(Performer{clip, JointTree(clip), {}, {}});
    const std::vector<Node>& nodes = performers.back().tree.nodes();
    performers.back().angles.assign(nodes.size(), Vec3::Zero());
    append_node(text, nodes, 0, clips.size() > 1 ? prefix_of(clip.name) : "", units_per_metre, 0);
  }
  text += "MOTION\nFrames: " + std::to_string(clips[0].poses.size()) +
          "\nFrame Time: " + exact_text(1.0 / clips[0].fps) + "\n";
  for (std::size_t f = 0; f < clips[0].poses.size(); ++f) {
    for (Performer& performer : performers) {
      if (&performer != &performers.front()) text += ' ';
      append_frame(text, performer, f, units_per_metre);
    }
    text += '\n';
  }
  return text;
}

}  // namespace abrazo
