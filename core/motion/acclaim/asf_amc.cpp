#include "core/motion/acclaim/asf_amc.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>

#include "core/base/line_reader.hpp"
#include "core/base/text.hpp"
#include "core/motion/acclaim/acclaim_skeleton.hpp"

namespace abrazo {

namespace {

/// End points of all bones for one frame of values.
class AcclaimPose {
 public:
  explicit AcclaimPose(const AcclaimSkeleton& skeleton)
      : skeleton_(skeleton), world_(skeleton.bones.size()) {}

  /// @param values  per bone its dofs; angles in units of `angle_unit` radians
  Positions ends(const std::vector<std::vector<double>>& values, double angle_unit) {
    Positions ends(static_cast<Eigen::Index>(skeleton_.bones.size()), 3);
    for (std::size_t b = 0; b < skeleton_.bones.size(); ++b) {
      const AcclaimBone& bone = skeleton_.bones[b];
      Vec3 angles = Vec3::Zero(), position = skeleton_.root_position;
      for (std::size_t d = 0; d < bone.dofs.size(); ++d) {
        if (bone.dofs[d] < 3)
          angles[bone.dofs[d]] = values[b][d] * angle_unit;
        else
          position[bone.dofs[d] - 3] = values[b][d];
      }
      const Eigen::Matrix3d turn = rotation_of(angles, bone.order);
      const auto row = static_cast<Eigen::Index>(b);
      if (bone.parent < 0) {
        world_[b] = turn;
        ends.row(row) = position.transpose();
      } else {
        world_[b] =
            world_[static_cast<std::size_t>(bone.parent)] * (bone.axis * turn * bone.axis.transpose());
        ends.row(row) = ends.row(bone.parent) + (world_[b] * bone.offset).transpose();
      }
    }
    return ends;
  }

 private:
  const AcclaimSkeleton& skeleton_;
  std::vector<Eigen::Matrix3d> world_;
};

class AmcParser {
 public:
  AmcParser(std::string_view text, std::string_view where, const AcclaimSkeleton& skeleton,
            NamedMotion& motion);
  Status parse();

 private:
  Status read_line(std::string_view line);
  Status read_header(std::string_view word);
  Status begin_frame(long long number);
  Status read_bone(std::string_view name, std::string_view rest);
  void finish_frame();
  void finish_last_frame();
  void report_absences();
  void warn(std::string kind, int line, std::string detail) {
    motion_.warnings.push_back({std::move(kind), line, std::move(detail)});
  }
  /// A file cut off while it was written ends inside a line.
  bool at_last_line() const { return trimmed(lines_.rest()).empty(); }
  Error error(std::string message) const { return error_at(where_, lines_.number(), std::move(message)); }

  /// Frames in which a bone that can move has no line.
  struct Absence {
    std::size_t frames = 0;
    int first_line = 0;
    long long first_frame = 0;
  };

  LineReader lines_;
  std::string where_;
  const AcclaimSkeleton& skeleton_;
  NamedMotion& motion_;
  AcclaimPose pose_;
  std::map<std::string, std::size_t, std::less<>> bone_of_name_;
  std::vector<std::vector<double>> values_;  ///< of the frame being read; missing bones keep their last value
  std::vector<std::uint64_t> last_seen_;     ///< per bone, the count of frames begun when it was last given
  std::vector<Absence> absences_;
  std::size_t movable_ = 0;       ///< bones with dofs
  std::size_t given_ = 0;         ///< of these, given in the frame being read
  std::size_t given_before_ = 0;  ///< the same of the frame before
  std::uint64_t begun_ = 0;
  long long frame_number_ = 0;
  int frame_line_ = 0;
  std::size_t jumps_ = 0;
  int first_jump_line_ = 0;
  bool cut_off_ = false;
  bool degrees_;
};

AmcParser::AmcParser(std::string_view text, std::string_view where, const AcclaimSkeleton& skeleton,
                     NamedMotion& motion)
    : lines_(text),
      where_(where),
      skeleton_(skeleton),
      motion_(motion),
      pose_(skeleton),
      last_seen_(skeleton.bones.size(), 0),
      absences_(skeleton.bones.size()),
      degrees_(skeleton.degrees) {
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    bone_of_name_.emplace(skeleton.bones[b].name, b);
    values_.emplace_back(skeleton.bones[b].dofs.size(), 0.0);
    if (!skeleton.bones[b].dofs.empty()) ++movable_;
  }
}

Status AmcParser::read_header(std::string_view word) {
  const std::string name = lower_case(word);
  if (name != ":degrees" && name != ":radians") return Done{};
  if (!motion_.frames.empty() || begun_ > 0)
    return error(in_quotes(word) + " must come before the first frame");
  degrees_ = name == ":degrees";
  if (degrees_ != skeleton_.degrees)
    warn("angle-unit", lines_.number(),
         std::string("the motion is in ") + (degrees_ ? "degrees" : "radians") +
             ", its skeleton in the other unit; both were obeyed");
  return Done{};
}

void AmcParser::finish_frame() {
  if (begun_ == 0) return;
  if (given_ < movable_) {
    for (std::size_t b = 0; b < values_.size(); ++b) {
      if (values_[b].empty() || last_seen_[b] == begun_) continue;
      Absence& absence = absences_[b];
      if (absence.frames++ == 0) absence = {1, frame_line_, frame_number_};
    }
  }
  motion_.frames.push_back(pose_.ends(values_, degrees_ ? std::numbers::pi / 180.0 : 1.0));
  given_before_ = given_;
}

Status AmcParser::begin_frame(long long number) {
  finish_frame();
  if (begun_ > 0 && number != frame_number_ + 1 && jumps_++ == 0) first_jump_line_ = lines_.number();
  frame_number_ = number;
  frame_line_ = lines_.number();
  given_ = 0;
  ++begun_;
  return Done{};
}

Status AmcParser::read_bone(std::string_view name, std::string_view rest) {
  const auto found = bone_of_name_.find(name);
  if (found == bone_of_name_.end()) {
    if (cut_off_ = at_last_line() && begun_ > 1; cut_off_) return Done{};
    return error("the skeleton has no bone " + in_quotes(name) +
                 "; is it the .asf this motion was made with?");
  }
  const std::size_t b = found->second;
  const std::size_t expected = values_[b].size();
  if (last_seen_[b] == begun_)
    return error("frame " + std::to_string(frame_number_) + " has " + in_quotes(name) + " twice");
  std::size_t count = 0;
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest), ++count) {
    const auto number = parse_number(word);
    if (!number || !std::isfinite(*number)) {
      if (cut_off_ = !number && at_last_line() && begun_ > 1; cut_off_) return Done{};
      return error("frame " + std::to_string(frame_number_) + ": expected a number for " + in_quotes(name) +
                   ", found " + in_quotes(word));
    }
    if (count < expected) values_[b][count] = *number;
  }
  if (count != expected) {
    if (cut_off_ = count < expected && at_last_line() && begun_ > 1; cut_off_) return Done{};
    return error("expected " + std::to_string(expected) + " values for " + in_quotes(name) +
                 " (its dof line in the skeleton), found " + std::to_string(count));
  }
  last_seen_[b] = begun_;
  if (expected > 0) ++given_;
  return Done{};
}

Status AmcParser::read_line(std::string_view line) {
  std::string_view rest = line;
  const std::string_view word = take_word(rest);
  if (word.empty() || word.front() == '#') return Done{};
  if (word.front() == ':') return read_header(word);
  if (trimmed(rest).empty())
    if (const auto number = parse_integer(word)) return begin_frame(*number);
  if (begun_ == 0) return error("expected a frame number, found " + in_quotes(word));
  return read_bone(word, rest);
}

void AmcParser::finish_last_frame() {
  if (cut_off_ || (begun_ > 1 && given_ < given_before_)) {
    warn("truncated", frame_line_,
         "the file ends inside frame " + std::to_string(frame_number_) + "; the " +
             std::to_string(motion_.frames.size()) + " whole frames were kept");
    return;
  }
  finish_frame();
}

void AmcParser::report_absences() {
  for (std::size_t b = 0; b < absences_.size(); ++b) {
    const Absence& absence = absences_[b];
    if (absence.frames == 0) continue;
    const std::string name = in_quotes(skeleton_.bones[b].name);
    if (absence.frames == motion_.frames.size())
      warn("missing-bone", absence.first_line, name + " has no values in any frame; it was kept at rest");
    else
      warn("missing-bone", absence.first_line,
           name + " has no values in " + std::to_string(absence.frames) + " of " +
               std::to_string(motion_.frames.size()) + " frames, first in frame " +
               std::to_string(absence.first_frame) + "; it was held as before");
  }
  if (jumps_ > 0)
    warn("frame-number", first_jump_line_,
         "frame numbers jump " + std::to_string(jumps_) +
             " time(s), first here; frames were taken as they stand, evenly spaced");
}

Status AmcParser::parse() {
  std::string_view line;
  while (!cut_off_ && lines_.next(line))
    if (const Status read = read_line(line); !read) return read;
  finish_last_frame();
  report_absences();
  if (motion_.frames.empty())
    return Error{"has no frames; expected frame numbers, each followed by one line per bone", where_};
  return Done{};
}

}  // namespace

Result<NamedMotion> read_asf_amc(std::string_view asf, std::string_view asf_where, std::string_view amc,
                                 std::string_view amc_where) {
  const Result<AcclaimSkeleton> skeleton = parse_asf(asf, asf_where);
  if (!skeleton) return skeleton.error();
  NamedMotion motion;
  motion.name = stem_of(amc_where);
  for (const AcclaimBone& bone : skeleton->bones) {
    motion.points.push_back(bone.name);
    motion.parents.push_back(bone.parent);
  }
  if (skeleton->length_unit) motion.metres_per_unit = (1.0 / *skeleton->length_unit) * 2.54 / 100.0;
  motion.warnings = skeleton->warnings;
  if (const Status read = AmcParser(amc, amc_where, *skeleton, motion).parse(); !read) return read.error();
  return motion;
}

}  // namespace abrazo
