#include "core/motion/files/import_clip.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/base/atomic_file.hpp"
#include "core/base/statistics.hpp"
#include "core/base/text.hpp"
#include "core/motion/body/body.hpp"
#include "core/motion/body/person_bounds.hpp"
#include "core/motion/files/up_axis_choice.hpp"
#include "core/motion/joints/map_choice.hpp"
#include "core/motion/joints/marker_gaps.hpp"
#include "core/motion/joints/marker_model.hpp"
#include "core/motion/joints/marker_words.hpp"
#include "core/motion/joints/performers.hpp"

namespace abrazo {

namespace {

constexpr double smallest_adult_m = 1.0, tallest_adult_m = 2.3;  ///< standing heights that raise no question
constexpr double usual_height_m = 1.7;
constexpr double lowest_floor_m = -0.10, highest_floor_m = 0.20;  ///< toe-base heights that raise no question
constexpr double toe_rest_height_m = 0.04;                        ///< of a standing foot in the CMU takes
constexpr double slowest_fps = 0.1, fastest_fps = 10'000;
constexpr double farthest_m = 1e6;
constexpr double cmu_rate_fps = 120.0;  ///< CMU's published rate; AMC files do not state theirs
constexpr double cmu_unit_m = (1.0 / 0.45) * 2.54 / 100.0;

std::string rounded(double value, int digits) {
  constexpr double countable = 1e6;  // beyond, a damaged file's number would fill the line with digits
  char text[64];
  std::snprintf(text, sizeof text, std::abs(value) < countable ? "%.*f" : "%.*g", digits, value);
  return text;
}

void warn(ImportReport& report, std::string kind, std::string detail, Hint hint = Hint::None) {
  report.warnings.push_back({std::move(kind), 0, std::move(detail), hint});
}

/// Where the evidence leaves open what a person can say.
void ask(ImportReport& report, std::string kind, std::string detail, Hint hint = Hint::None) {
  report.warnings.push_back({std::move(kind), 0, std::move(detail), hint, true});
}

std::string names_of(const std::vector<int>& joint_list) {
  std::string names;
  for (const int joint : joint_list)
    names += (names.empty() ? "" : ", ") + std::string(joint_names[static_cast<std::size_t>(joint)]);
  return names;
}

std::string never_seen(const NamedMotion& motion) {
  std::string words;
  for (const ImportWarning& warning : motion.warnings)
    if (warning.kind == "never-seen") words += " (" + warning.detail + ")";
  return words;
}

Error no_map_fits(const NamedMotion& motion, const ChosenMap& closest, bool only_one) {
  constexpr std::size_t most_joints = 3, most_points = 6;
  const std::vector<int>& missing = closest.binding.missing;
  std::string message = only_one ? "the joint map '" + closest.map.name + "' does not fit: the file lacks "
                                 : "no joint map fits; the closest, '" + closest.map.name + "', lacks ";
  for (std::size_t i = 0; i < missing.size() && i < most_joints; ++i)
    message += (i > 0 ? ", " : "") + describe_joint(closest.map, missing[i]);
  if (missing.size() > most_joints)
    message += " and " + std::to_string(missing.size() - most_joints) + " more";
  message += never_seen(motion);
  message +=
      ". The file's points: " + some_of(motion.points, most_points) +
      R"(. Say which point is which joint in a JSON file {"name": "mine", "joints": {"root": "Hips", "head": )"
      R"({"Neck": 0.3, "Top": 0.7}, ...}} with all 25 joints)";
  return Error{message, motion.name, Hint::NameJointMap};
}

/// "Hips", "0.5 LeftHip + 0.5 RightHip".
std::string sum_of_points(const NamedMotion& motion, const std::vector<std::pair<int, double>>& terms) {
  std::string words;
  for (const auto& [point, weight] : terms)
    words += (words.empty() ? "" : " + ") +
             (weight == 1 ? "" : exact_text(std::round(weight * 1e4) / 1e4) + " ") +
             motion.points[static_cast<std::size_t>(point)];
  return words;
}

/// Joints that a map estimates from the points beside them, and those that no map knows.
std::vector<int> not_in_the_file(const ChosenMap& chosen) {
  std::vector<int> joint_list = chosen.binding.estimated;
  joint_list.insert(joint_list.end(), chosen.inferred.begin(), chosen.inferred.end());
  std::ranges::sort(joint_list);
  joint_list.erase(std::ranges::unique(joint_list).begin(), joint_list.end());
  return joint_list;
}

Result<JointBinding> bind(const NamedMotion& motion, const ImportOptions& options, ImportReport& report) {
  ChosenMap chosen = choose_map(motion, options.joint_map);
  if (!chosen.fits()) return no_map_fits(motion, chosen, options.joint_map.has_value());
  if (report.joint_map.empty()) {
    report.joint_map = chosen.map.name;
    for (std::size_t j = 0; j < joint_count; ++j)
      report.joint_points[j] = sum_of_points(motion, chosen.binding.terms[j]);
  }
  report.inferred_joints = not_in_the_file(chosen);
  if (!report.inferred_joints.empty())
    warn(report, "inferred-joints",
         std::to_string(report.inferred_joints.size()) +
             " of the 25 joints are not in the file and were inferred: " + names_of(report.inferred_joints));
  return std::move(chosen.binding);
}

bool has_bones(const NamedMotion& motion) {
  return std::ranges::any_of(motion.parents, [](int parent) { return parent >= 0; });
}

/// Points without bones between them, of which some are called like markers of a set, or none like a joint.
bool looks_like_markers(const MarkerFit& fit, const NamedMotion& motion) {
  constexpr std::size_t fewest_markers = 6, fewest_points = 12;
  if (has_bones(motion)) return false;
  return fit.found >= fewest_markers || (motion.points.size() >= fewest_points &&
                                         choose_map(motion, {}).binding.missing.size() == joint_count);
}

/// The joints by a model that the names' words gave, with a question.
Result<std::optional<NamedMotion>> joints_by_words(const MarkerModel& model, const NamedMotion& motion,
                                                   const ImportOptions& options, ImportReport& report) {
  NamedMotion markers = motion;
  std::vector<int> inferred = add_inferred_toes(model, markers);
  const double unit =
      options.metres_per_unit.value_or(motion.metres_per_unit.value_or(unit_of_markers(model, markers)));
  Result<NamedMotion> joints = joints_of_markers(model, markers, unit);
  if (!joints) return joints.error();
  report.joint_map = model.name;
  report.warnings = joints->warnings;
  if (!inferred.empty())
    warn(report, "inferred-toes",
         "no marker is on the toes of " + std::string(inferred.size() == 2 ? "both feet" : "one foot") +
             ": they were put ahead of the ankles and below");
  ask(report, "markers",
      "the markers are of no known set, and were placed by the words of their names; look whether the body "
      "is "
      "right, or name a marker model",
      Hint::NameJointMap);
  joints->inferred_joints.insert(joints->inferred_joints.end(), inferred.begin(), inferred.end());
  std::ranges::sort(joints->inferred_joints);
  return std::optional<NamedMotion>(std::move(*joints));
}

/// Where markers were captured, the joints by the marker model that was said or fits; nothing otherwise.
Result<std::optional<NamedMotion>> joints_by_markers(const NamedMotion& motion, const ImportOptions& options,
                                                     ImportReport& report) {
  if (!options.marker_model && (options.joint_map || choose_map(motion, {}).fits()))
    return std::optional<NamedMotion>();
  MarkerFit fit = options.marker_model ? fit_of(*options.marker_model, motion.points)
                                       : nearest_marker_model(motion.points);
  if (!options.marker_model && !fit.missing.empty() && !has_bones(motion))
    if (const auto model = marker_model_by_words(motion.points))
      return joints_by_words(*model, motion, options, report);
  if (options.marker_model && !fit.missing.empty())
    return Error{
        "the marker model '" + fit.model->name + "' does not fit: the file lacks " + some_of(fit.missing),
        motion.name};
  if (!fit.missing.empty()) {
    if (looks_like_markers(fit, motion)) return Error{why_no_body(fit) + never_seen(motion), motion.name};
    return std::optional<NamedMotion>();
  }
  const MarkerModel* chosen = fit.model;
  const double unit =
      options.metres_per_unit.value_or(motion.metres_per_unit.value_or(unit_of_markers(*chosen, motion)));
  Result<NamedMotion> joints = joints_of_markers(*chosen, motion, unit);
  if (!joints) return joints.error();
  report.joint_map = chosen->name;
  report.warnings = joints->warnings;
  return std::optional<NamedMotion>(std::move(*joints));
}

/// Why a joint is at no place: the points it is found from.
std::string gaps_behind(const NamedMotion& motion, const JointBinding& binding, int joint) {
  std::vector<int> points;
  for (const auto& [point, weight] : binding.terms[static_cast<std::size_t>(joint)]) points.push_back(point);
  const std::string gaps = gaps_of(motion, points);
  return gaps.empty() ? "is not a finite number" : "is not known: " + gaps;
}

Result<std::vector<Pose>> extract(const NamedMotion& motion, const JointBinding& binding) {
  std::vector<Pose> poses;
  poses.reserve(motion.frames.size());
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    poses.push_back(binding.joints_of(motion.frames[f]));
    if (poses.back().allFinite()) continue;
    for (int j = 0; j < joint_count; ++j)
      if (!poses.back().row(j).allFinite())
        return Error{"the position of " + std::string(joint_names[static_cast<std::size_t>(j)]) + " " +
                         gaps_behind(motion, binding, j) +
                         "; leave that frame out or export the motion again",
                     motion.name + ": frame " + std::to_string(f)};
  }
  if (poses.empty()) return Error{"has no frames", motion.name};
  return poses;
}

/// The axis that a person said, or the one that the file states and the posture confirms.
UpAxis settle_up_axis(const NamedMotion& motion, const ImportOptions& options, const std::vector<Pose>& poses,
                      ImportReport& report) {
  if (options.up_axis) return *options.up_axis;
  UpAxisChoice choice = choose_up_axis(motion.up_axis, poses);
  report.up_axis_guessed = choice.guessed;
  if (choice.warning) report.warnings.push_back(std::move(*choice.warning));
  return choice.axis;
}

struct GuessedUnit {
  double metres = 1;
  bool is_only_one = false;  ///< with each other unit the performer would be no adult
};

/// Metres, the CMU unit, inches, centimetres or millimetres: whichever makes an adult of the performer.
GuessedUnit guess_unit(double height_in_file_units) {
  GuessedUnit guess;
  double best_misfit = std::numeric_limits<double>::infinity();
  int adults = 0;
  for (const double unit : {1.0, cmu_unit_m, 0.0254, 0.01, 0.001}) {
    const double height = height_in_file_units * unit;
    if (height >= smallest_adult_m && height <= tallest_adult_m) ++adults;
    const double misfit = std::abs(std::log(height / usual_height_m));
    if (misfit < best_misfit) guess.metres = unit, best_misfit = misfit;
  }
  guess.is_only_one = adults == 1;
  return guess;
}

void settle_unit(const NamedMotion& motion, const ImportOptions& options, std::vector<Pose>& poses,
                 ImportReport& report) {
  const double raw_height = body_of(poses).height();
  if (options.metres_per_unit) {
    report.metres_per_unit = *options.metres_per_unit;
  } else if (motion.metres_per_unit) {
    report.metres_per_unit = *motion.metres_per_unit;
  } else {
    report.unit_guessed = true;
    const GuessedUnit guess = raw_height > 0 ? guess_unit(raw_height) : GuessedUnit{};
    report.metres_per_unit = guess.metres;
    (guess.is_only_one ? warn : ask)(report, "units",
                                     "the file does not state its unit; " + exact_text(guess.metres) +
                                         " m was guessed from the standing height of " +
                                         rounded(raw_height, 2) + " units",
                                     Hint::None);
  }
  for (Pose& pose : poses) pose *= report.metres_per_unit;
  report.height_m = raw_height * report.metres_per_unit;
  if (report.height_m < smallest_adult_m || report.height_m > tallest_adult_m)
    ask(report, "height",
        "the performer would stand " + rounded(report.height_m, 2) + " m tall; set the unit if that is wrong",
        Hint::SetUnit);
}

Status settle_rate(const NamedMotion& motion, const ImportOptions& options, ImportReport& report) {
  if (options.fps) {
    report.fps = *options.fps;
  } else if (motion.fps) {
    report.fps = *motion.fps;
  } else {
    report.fps = cmu_rate_fps;
    report.fps_guessed = true;
    // A skeleton with CMU's unit is CMU's, whose rate is known.
    const bool is_cmu = motion.metres_per_unit && std::abs(*motion.metres_per_unit - cmu_unit_m) < 1e-9;
    (is_cmu ? warn : ask)(
        report, "fps", "the file does not state its frame rate; 120 fps was guessed, set it if it is another",
        Hint::SetFrameRate);
  }
  if (report.fps >= slowest_fps && report.fps <= fastest_fps) return Done{};
  return Error{fmt::format("has {:.4g} frames per second; expected {} to {}, set the rate if that is wrong",
                           report.fps, slowest_fps, fastest_fps),
               motion.name, Hint::SetFrameRate};
}

/// A place so far away is no place of a person, and its square may be beyond all numbers.
Status check_places(const std::vector<Pose>& poses, const std::string& name) {
  for (std::size_t f = 0; f < poses.size(); ++f)
    if ((poses[f].array().abs() > farthest_m).any())
      return Error{
          fmt::format(
              "frame {} (counted from 0) has a joint more than {:.0f} km away; set the unit if that is "
              "wrong, or leave the frame out",
              f, farthest_m / 1000),
          name, Hint::SetUnit};
  return Done{};
}

bool rests_near_zero(const ImportReport& report) {
  return report.floor_y_m >= lowest_floor_m && report.floor_y_m <= highest_floor_m;
}

void settle_floor(const ImportOptions& options, std::vector<Pose>& poses, ImportReport& report) {
  report.floor_y_m = body_of(poses).toe_rest_height;
  if (options.floor_m) {
    report.floor_shift_m = -*options.floor_m;
    for (Pose& pose : poses) pose.col(1).array() += report.floor_shift_m;
    return;
  }
  if (rests_near_zero(report)) return;
  report.floor_shift_m = toe_rest_height_m - report.floor_y_m;
  for (Pose& pose : poses) pose.col(1).array() += report.floor_shift_m;
  ask(report, "floor",
      "the toe bases rest at " + rounded(report.floor_y_m, 3) + " m; everything was moved by " +
          rounded(report.floor_shift_m, 3) + " m so that they rest at 0.04 m");
}

/// Mean distance the joints move relative to the root from one frame to the next [m].
double change(const Pose& from, const Pose& to) {
  const Pose moved = (to.rowwise() - to.row(0)) - (from.rowwise() - from.row(0));
  return moved.rowwise().norm().mean();
}

/// Many files begin with the rest pose (often a T): the joints then jump once, after the first frame.
void look_for_rest_pose(const std::vector<Pose>& poses, ImportReport& report) {
  if (poses.size() < 3) return;
  const double jump = change(poses[0], poses[1]);
  double largest_later = 0;
  for (std::size_t f = 2; f < std::min<std::size_t>(poses.size(), 120); ++f)
    largest_later = std::max(largest_later, change(poses[f - 1], poses[f]));
  if (jump > 0.08 && jump > 5 * largest_later)
    warn(report, "first-frame",
         "the first frame is " + rounded(jump, 2) +
             " m (mean over the joints) away from the second: probably the rest pose; it was kept");
}

/// After unit, axes and floor are settled. The frames are kept: a few bad ones make no motion useless.
void look_for_a_person(const std::vector<Pose>& poses, ImportReport& report) {
  const PersonDoubts doubts = person_doubts(poses, report.fps);
  const std::string of_all = " of " + std::to_string(poses.size()) + " frames";
  // A few frames are noise of the capture; where most are wrong the reading is.
  const auto tell = [frames = static_cast<int>(poses.size())](int wrong) {
    return 2 * wrong > frames ? ask : warn;
  };
  if (doubts.poses > 0)
    tell(static_cast<int>(doubts.poses))(
        report, "not-a-person",
        std::to_string(doubts.poses) + of_all + " cannot be a person's; the first is frame " +
            std::to_string(doubts.first_pose) + ": " + doubts.first_reason +
            (doubts.first_reason.ends_with('?') ? "" : ".") +
            " They are kept, and the partner is held there; leave them out, or set unit and axes",
        Hint::None);
  if (doubts.jumps > 0)
    tell(static_cast<int>(doubts.jumps))(report, "jumps",
                                         "the performer jumps in " + std::to_string(doubts.jumps) + of_all +
                                             " faster than anybody moves; the first is frame " +
                                             std::to_string(doubts.first_jump) +
                                             ". They are kept; look there, or set the rate if that is wrong",
                                         Hint::SetFrameRate);
}

}  // namespace

Result<ImportedClip> import_clip(const NamedMotion& file_points, const ImportOptions& options) {
  if (options.metres_per_unit && !(*options.metres_per_unit > 0 && std::isfinite(*options.metres_per_unit)))
    return Error{"metres per unit must be above 0", file_points.name};
  if (options.fps && !(*options.fps > 0 && std::isfinite(*options.fps)))
    return Error{"the frame rate must be above 0", file_points.name};
  if (options.floor_m && !std::isfinite(*options.floor_m))
    return Error{"the height of the floor must be a finite number of metres", file_points.name};
  ImportedClip result;
  ImportReport& report = result.report;
  report.warnings = file_points.warnings;
  report.animations = file_points.animations;
  Result<std::optional<NamedMotion>> by_markers = joints_by_markers(file_points, options, report);
  if (!by_markers) return by_markers.error();
  const NamedMotion& motion = *by_markers ? **by_markers : file_points;
  const Result<JointBinding> binding = bind(motion, options, report);
  if (!binding) return binding.error();
  if (*by_markers) report.inferred_joints = motion.inferred_joints;
  Result<std::vector<Pose>> poses = extract(motion, *binding);
  if (!poses) return poses.error();
  report.up_axis = settle_up_axis(motion, options, *poses, report);
  for (Pose& pose : *poses) turn_to_y_up(pose, report.up_axis);
  settle_unit(motion, options, *poses, report);
  if (const Status placed = check_places(*poses, motion.name); !placed) return placed.error();
  if (const Status rate = settle_rate(motion, options, report); !rate) return rate.error();
  settle_floor(options, *poses, report);
  look_for_rest_pose(*poses, report);
  look_for_a_person(*poses, report);
  result.clip = Clip{motion.name, report.fps, std::move(*poses)};
  return result;
}

bool ImportReport::asks() const {
  return animations.size() > 1 || std::ranges::any_of(warnings, &ImportWarning::asks);
}

bool ImportReport::asks_about(std::string_view kind) const {
  return std::ranges::any_of(
      warnings, [&](const ImportWarning& warning) { return warning.asks && warning.kind == kind; });
}

void share_floor(std::span<ImportedClip* const> performers) {
  const auto is_of_floor = [](const ImportWarning& warning) { return warning.kind == "floor"; };
  const bool moved = std::ranges::any_of(performers, [&](const ImportedClip* one) {
    return std::ranges::any_of(one->report.warnings, is_of_floor);
  });
  if (performers.size() < 2 || !moved) return;
  const ImportedClip& lowest = **std::ranges::min_element(
      performers, {}, [](const ImportedClip* one) { return one->report.floor_y_m; });
  const bool on_floor =
      std::ranges::any_of(performers, [](const ImportedClip* one) { return rests_near_zero(one->report); });
  const double shift_m = on_floor ? 0 : toe_rest_height_m - lowest.report.floor_y_m;
  for (ImportedClip* one : performers) {
    ImportReport& report = one->report;
    for (Pose& pose : one->clip.poses) pose.col(1).array() += shift_m - report.floor_shift_m;
    report.floor_shift_m = shift_m;
    std::erase_if(report.warnings, is_of_floor);
    if (!on_floor)
      ask(report, "floor",
          "the toe bases of " + lowest.clip.name + " rest at " + rounded(lowest.report.floor_y_m, 3) +
              " m; all performers of the take were moved by " + rounded(shift_m, 3) + " m");
    else if (!rests_near_zero(report))
      warn(report, "floor",
           "the toe bases rest at " + rounded(report.floor_y_m, 3) +
               " m, off the floor of the other performer; nobody was moved");
  }
}

bool joints_are_known(const NamedMotion& motion) {
  return choose_map(motion, {}).fits() || nearest_marker_model(motion.points).missing.empty();
}

bool is_builtin_joint_map(const std::string& name) {
  const auto called = [&](const auto& each) { return each.name == name; };
  return std::ranges::any_of(builtin_joint_maps(), called) ||
         std::ranges::any_of(builtin_marker_models(), called);
}

Status choose_joints(const std::string& name_or_file, ImportOptions& options) {
  for (const MarkerModel& model : builtin_marker_models())
    if (model.name == name_or_file) {
      options.marker_model = model;
      return Done{};
    }
  for (const JointMap& map : builtin_joint_maps())
    if (map.name == name_or_file) {
      options.joint_map = map;
      return Done{};
    }
  const auto text = read_whole_file(name_or_file);
  if (!text) return text.error();
  if (is_marker_model(*text)) {
    auto model = parse_marker_model(*text, name_or_file);
    if (!model) return model.error();
    options.marker_model = std::move(*model);
    return Done{};
  }
  auto map = parse_joint_map(*text, name_or_file);
  if (!map) return map.error();
  options.joint_map = std::move(*map);
  return Done{};
}

}  // namespace abrazo
