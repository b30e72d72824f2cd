#include "core/motion/acclaim/acclaim_skeleton.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "core/base/line_reader.hpp"
#include "core/base/text.hpp"
#include "core/base/units.hpp"

namespace abrazo {

Eigen::Matrix3d rotation_of(const Vec3& angles_rad, const RotationOrder& order) {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for (const int axis : order)
    rotation = Eigen::AngleAxisd(angles_rad[axis], Vec3::Unit(axis)).toRotationMatrix() * rotation;
  return rotation;
}

namespace {

/// The parsed file, before bones are ordered: angles in file units, parents by name.
struct RawBone {
  AcclaimBone bone;
  Vec3 direction = Vec3::Zero();
  double length = 0;
  Vec3 axis_angles = Vec3::Zero();
  int line = 0;
};

class AsfParser {
 public:
  AsfParser(std::string_view text, std::string_view where) : lines_(text), where_(where) {
    root_.bone.name = "root";
  }

  Result<AcclaimSkeleton> parse();

 private:
  Status read_line(std::string_view line);
  Status read_units(std::string_view key, std::string_view rest);
  Status read_root(std::string_view key, std::string_view rest);
  Status read_bone(std::string_view key, std::string_view rest);
  Status read_hierarchy(std::string_view parent, std::string_view children);
  Status finish_bone();
  Status read_vector(std::string_view key, std::string_view& rest, Vec3& vector) const;
  Status read_order(std::string_view word, RotationOrder& order) const;
  Status read_dofs(std::string_view rest, bool is_root, std::vector<AcclaimBone::Dof>& dofs) const;
  Result<AcclaimSkeleton> assemble();
  Error error(std::string message) const { return error_at(where_, lines_.number(), std::move(message)); }

  LineReader lines_;
  std::string where_;
  std::string section_;
  AcclaimSkeleton skeleton_;
  RawBone root_;
  Vec3 root_orientation_ = Vec3::Zero();
  bool inside_bone_ = false;
  RawBone current_;
  std::vector<RawBone> bones_;  ///< in file order
  std::map<std::string, std::string, std::less<>> parents_;
};

Status AsfParser::read_vector(std::string_view key, std::string_view& rest, Vec3& vector) const {
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = take_word(rest);
    const auto number = parse_number(word);
    if (!number || !std::isfinite(*number))
      return error("expected three numbers after " + in_quotes(key) +
                   (word.empty() ? ", the line ends early" : ", found " + in_quotes(word)));
    vector[i] = *number;
  }
  return Done{};
}

Status AsfParser::read_order(std::string_view word, RotationOrder& order) const {
  const std::string letters = lower_case(word);
  if (letters.size() != 3 ||
      !std::is_permutation(letters.begin(), letters.end(), std::string_view("xyz").begin()))
    return error("expected an order of the axes such as XYZ, found " + in_quotes(word));
  for (std::size_t i = 0; i < 3; ++i) order[i] = letters[i] - 'x';
  return Done{};
}

Status AsfParser::read_dofs(std::string_view rest, bool is_root, std::vector<AcclaimBone::Dof>& dofs) const {
  dofs.clear();
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    const std::string name = lower_case(word);
    const bool turns = name.size() == 2 && name[0] == 'r' && name[1] >= 'x' && name[1] <= 'z';
    const bool moves = name.size() == 2 && name[0] == 't' && name[1] >= 'x' && name[1] <= 'z';
    if (!turns && !(moves && is_root))
      return error("cannot read the degree of freedom " + in_quotes(word) + "; bones may have rx, ry and rz" +
                   (is_root ? ", the root also TX, TY and TZ" : " (only the root moves)"));
    const AcclaimBone::Dof dof = name[1] - 'x' + (moves ? 3 : 0);
    if (std::find(dofs.begin(), dofs.end(), dof) != dofs.end())
      return error("the degree of freedom " + in_quotes(word) + " is named twice");
    dofs.push_back(dof);
  }
  return Done{};
}

Status AsfParser::read_units(std::string_view key, std::string_view rest) {
  const std::string_view word = take_word(rest);
  if (key == "length") {
    const auto number = parse_number(word);
    if (!number || !(*number > 0) || !std::isfinite(*number))
      return error("expected a length unit above 0, found " + in_quotes(word));
    skeleton_.length_unit = *number;
  } else if (key == "angle") {
    const std::string unit = lower_case(word);
    if (unit != "deg" && unit != "rad")
      return error("expected 'angle deg' or 'angle rad', found " + in_quotes(word));
    skeleton_.degrees = unit == "deg";
  }
  return Done{};
}

Status AsfParser::read_root(std::string_view key, std::string_view rest) {
  if (key == "order") return read_dofs(rest, true, root_.bone.dofs);
  if (key == "axis") return read_order(take_word(rest), root_.bone.order);
  if (key == "position") return read_vector(key, rest, skeleton_.root_position);
  if (key == "orientation") return read_vector(key, rest, root_orientation_);
  return Done{};
}

Status AsfParser::finish_bone() {
  if (current_.bone.name.empty())
    return error_at(where_, current_.line, "the bone that begins here has no name");
  for (const RawBone& other : bones_)
    if (other.bone.name == current_.bone.name)
      return error_at(
          where_, current_.line,
          "there is a second bone " + in_quotes(current_.bone.name) + "; bone names must be unique");
  if (current_.bone.name == "root") return error_at(where_, current_.line, "a bone cannot be called 'root'");
  bones_.push_back(current_);
  inside_bone_ = false;
  return Done{};
}

Status AsfParser::read_bone(std::string_view key, std::string_view rest) {
  if (key == "begin") {
    if (inside_bone_) return error("'begin' inside the bone begun in line " + std::to_string(current_.line));
    inside_bone_ = true;
    current_ = RawBone{};
    current_.line = lines_.number();
    return Done{};
  }
  if (!inside_bone_) return error("expected 'begin', found " + in_quotes(key));
  if (key == "end") return finish_bone();
  if (key == "name") {
    current_.bone.name = trimmed(rest);
  } else if (key == "direction") {
    return read_vector(key, rest, current_.direction);
  } else if (key == "length") {
    const std::string_view word = take_word(rest);
    const auto number = parse_number(word);
    if (!number || !std::isfinite(*number))
      return error("expected the bone's length, found " + in_quotes(word));
    current_.length = *number;
  } else if (key == "axis") {
    if (const Status read = read_vector(key, rest, current_.axis_angles); !read) return read;
    const std::string_view order = take_word(rest);
    if (!order.empty()) return read_order(order, current_.bone.order);
  } else if (key == "dof") {
    return read_dofs(rest, false, current_.bone.dofs);
  } else if (key != "id" && key != "limits" && key != "bodymass" && key != "cofmass" && key.front() != '(') {
    skeleton_.warnings.push_back(
        {"unknown-field", lines_.number(), "the field " + in_quotes(key) + " was not used"});
  }
  return Done{};
}

Status AsfParser::read_hierarchy(std::string_view parent, std::string_view children) {
  if (parent == "begin" || parent == "end") return Done{};
  for (std::string_view child = take_word(children); !child.empty(); child = take_word(children)) {
    const auto [known, is_new] = parents_.emplace(child, parent);
    if (!is_new)
      return error("the bone " + in_quotes(child) + " already has the parent " + in_quotes(known->second));
  }
  return Done{};
}

Status AsfParser::read_line(std::string_view line) {
  std::string_view rest = line;
  const std::string_view word = take_word(rest);
  if (word.empty() || word.front() == '#') return Done{};
  if (word.front() == ':') {
    section_ = lower_case(word);
    return Done{};
  }
  if (section_ == ":hierarchy") return read_hierarchy(word, rest);
  const std::string key = lower_case(word);
  if (section_ == ":units") return read_units(key, rest);
  if (section_ == ":root") return read_root(key, rest);
  if (section_ == ":bonedata") return read_bone(key, rest);
  return Done{};  // :documentation and other free text
}

Result<AcclaimSkeleton> AsfParser::assemble() {
  const double angle_unit = skeleton_.degrees ? radians_per_degree : 1.0;
  skeleton_.bones.push_back(root_.bone);
  std::vector<bool> placed(bones_.size(), false);
  // Every pass adds the bones whose parents exist already: :bonedata may list children first.
  for (bool progress = true; progress;) {
    progress = false;
    for (std::size_t b = 0; b < bones_.size(); ++b) {
      const auto parent = parents_.find(bones_[b].bone.name);
      if (placed[b] || parent == parents_.end()) continue;
      const auto is_parent = [&](const AcclaimBone& bone) { return bone.name == parent->second; };
      const auto found = std::find_if(skeleton_.bones.begin(), skeleton_.bones.end(), is_parent);
      if (found == skeleton_.bones.end()) continue;
      AcclaimBone bone = bones_[b].bone;
      bone.parent = static_cast<int>(found - skeleton_.bones.begin());
      bone.offset = bones_[b].direction * bones_[b].length;
      bone.axis = rotation_of(bones_[b].axis_angles * angle_unit, bone.order);
      skeleton_.bones.push_back(std::move(bone));
      placed[b] = progress = true;
    }
  }
  for (std::size_t b = 0; b < bones_.size(); ++b)
    if (!placed[b])
      return error_at(
          where_, bones_[b].line,
          "the bone " + in_quotes(bones_[b].bone.name) + " is not joined to the root by :hierarchy");
  for (const auto& entry : parents_) {
    const auto& child = entry.first;
    if (std::none_of(bones_.begin(), bones_.end(),
                     [&](const RawBone& raw) { return raw.bone.name == child; }))
      return Error{":hierarchy names the bone " + in_quotes(child) + ", which :bonedata does not describe",
                   where_};
  }
  return std::move(skeleton_);
}

Result<AcclaimSkeleton> AsfParser::parse() {
  std::string_view line;
  while (lines_.next(line))
    if (const Status read = read_line(line); !read) return read.error();
  if (inside_bone_) return error_at(where_, current_.line, "the bone that begins here has no 'end'");
  if (bones_.empty())
    return Error{"has no bones; expected an Acclaim skeleton with :root, :bonedata and :hierarchy", where_};
  if (root_.bone.dofs.empty())
    return Error{"the :root section has no 'order' line such as 'order TX TY TZ RX RY RZ'", where_};
  if (!skeleton_.root_position.isZero(0) || !root_orientation_.isZero(0))
    skeleton_.warnings.push_back(
        {"root-offset", 0,
         "position and orientation of :root are not zero; the motion's values replace them, "
         "they are not added"});
  return assemble();
}

}  // namespace

Result<AcclaimSkeleton> parse_asf(std::string_view text, std::string_view where) {
  return AsfParser(text, where).parse();
}

}  // namespace abrazo
