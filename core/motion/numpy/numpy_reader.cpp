#include "core/motion/numpy/numpy_reader.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/limits.hpp"
#include "core/base/little_endian.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/order_choice.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/numpy/numpy_file.hpp"
#include "core/motion/numpy/smpl_body.hpp"

namespace abrazo {

namespace {

Result<std::optional<UpAxis>> up_axis_in(const NumpyFile& file) {
  const StoredArray* array = file.find({"up", "up_axis"});
  if (!array) return std::optional<UpAxis>();
  const Error expected{"expected the axis that points up, as a text: " + up_axis_names(), file.place(*array)};
  if (array->trouble) return *array->trouble;
  if (array->layout.is_number() || array->layout.count() != 1) return expected;
  const auto texts = texts_in(file, *array);
  if (!texts) return texts.error();
  std::string axis = lower_case(texts->front());
  if (axis.starts_with('+')) axis.erase(0, 1);
  const auto up = find_up_axis(axis);
  if (!up) return expected;
  return up;
}

/// What a file without positions of joints is, as far as its arrays tell.
Status refuse_what_is_no_positions(const NumpyFile& file) {
  if (holds_smpl_parameters(file))
    return Error{
        "holds the parameters of an SMPL body (poses, trans, betas), from which joints follow only with the "
        "body model, which is missing: it may not be shipped with Abrazo. Name the file of the model (.npz) "
        "that you have, or write the joints' positions (frames, joints, 3) with joint_names and fps by the "
        "program that has it",
        file.where()};
  const bool is_simulated = file.has("body_pos_w") || (file.has("joint_pos") && file.has("joint_vel"));
  if (is_simulated || file.has("qpos"))
    return Error{
        "holds the motion of a robot (joint angles and links: " + file.listed(3) +
            "), and a robot is no person: it has no joints of hips, spine and neck as a body has them. "
            "Expected positions (frames, joints, 3) of a person, such as those it was retargeted from",
        file.where()};
  return Done{};
}

/// Links of robots end in "_link", their axes in "_joint".
bool are_of_a_robot(const std::vector<std::string>& names) {
  const auto links = std::ranges::count_if(
      names, [](const std::string& name) { return name.ends_with("_link") || name.ends_with("_joint"); });
  return 2 * static_cast<std::size_t>(links) > names.size();
}

/// person1, person2, ... as long as they exist; else `positions`, else the only array of matching shape.
Result<std::vector<const StoredArray*>> arrays_of_performers(const NumpyFile& file) {
  std::vector<const StoredArray*> persons;
  while (const StoredArray* person = file.find({"person" + std::to_string(persons.size() + 1)}))
    persons.push_back(person);
  if (const StoredArray* named = file.find({"positions", ""}); named && persons.empty()) persons = {named};
  const std::string expected = "; expected (frames, joints, 3) of float32 or float64";
  for (const StoredArray* person : persons) {
    if (person->trouble) return *person->trouble;
    if (!person->is_positions())
      return Error{"has the shape " + person->layout.shape_text() + expected, file.place(*person)};
    if (person->layout.count() == 0)
      return Error{"has the shape " + person->layout.shape_text() + ": no " +
                       (person->layout.shape[0] == 0 ? "frames" : "joints") + expected,
                   file.place(*person)};
  }
  if (!persons.empty()) return persons;
  if (const Status positions = refuse_what_is_no_positions(file); !positions) return positions.error();
  std::vector<std::string> names;
  for (const StoredArray& array : file.arrays())
    if (array.is_positions() && array.layout.count() > 0)
      persons.push_back(&array), names.push_back(array.name);
  for (const StoredArray& array : file.arrays())
    if (persons.empty() && array.trouble) return *array.trouble;
  if (persons.empty())
    return Error{"holds no positions" + expected + ", found " + file.listed(12), file.where()};
  if (persons.size() > 1)
    return Error{"holds several arrays that may be positions (" + some_of(names) +
                     "); name the right one positions, or those of two people person1 and person2",
                 file.where()};
  return persons;
}

/// Names of the joints, and their origin.
struct FoundNames {
  std::vector<std::string> names;
  std::vector<ImportWarning> warnings;
};

Result<NamedMotion> motion_of(const NumpyFile& file, const StoredArray& array, const FoundNames& found) {
  const auto content = file.content_of(array);
  if (!content) return content.error();
  const NpyArray positions(array.layout, *content);
  NamedMotion motion;
  motion.name = array.name;
  motion.points = found.names;
  motion.parents.assign(motion.points.size(), -1);
  motion.warnings = found.warnings;
  const std::uint64_t frames = array.layout.shape[0], joints = array.layout.shape[1];
  motion.frames.reserve(frames);
  for (std::uint64_t f = 0; f < frames; ++f) {
    Positions places(static_cast<Eigen::Index>(joints), 3);
    for (std::uint64_t j = 0; j < joints; ++j)
      for (std::uint64_t axis = 0; axis < 3; ++axis) {
        const double value = positions.number(f, j, axis);
        if (std::isinf(value))
          return Error{"frame " + std::to_string(f) + " (counted from 0) has an infinite position of " +
                           in_quotes(motion.points[j]) + "; correct it, or write NaN where it was not seen",
                       file.place(array)};
        places(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(axis)) = value;
      }
    motion.frames.push_back(std::move(places));
  }
  if (!array.entry && content->size() > array.layout.bytes())
    motion.warnings.push_back({"trailing-bytes", 0,
                               std::to_string(content->size() - array.layout.bytes()) +
                                   " bytes behind the last element were not read"});
  return motion;
}

/// Without names: by the number of joints and, if that leaves several orders, by the bones.
Result<FoundNames> guess_order(const NumpyFile& file, const StoredArray& positions) {
  const std::size_t joints = positions.layout.shape[1];
  std::vector<const JointOrder*> fitting;
  for (const JointOrder& order : builtin_joint_orders())
    if (order.points.size() == joints) fitting.push_back(&order);
  const std::string where = file.place(positions);
  const std::string says_it = "say which joint is which with an array joint_names in a .npz";
  if (fitting.empty())
    return Error{std::to_string(joints) + " joints without names, and no known order has this number (" +
                     joint_order_names() + "); " + says_it,
                 where, Hint::NameJointOrder};
  const JointOrder* chosen = fitting.front();
  std::string reason = "since it alone has " + std::to_string(joints);
  if (fitting.size() > 1) {
    const auto motion = motion_of(file, positions, {chosen->points, {}});
    if (!motion) return motion.error();
    chosen = order_of_steady_bones(fitting, motion->frames);
    if (!chosen)
      return Error{std::to_string(joints) + " joints without names may be " + fitting[0]->name + " or " +
                       fitting[1]->name + "; " + says_it,
                   where, Hint::NameJointOrder};
    const JointOrder* other = chosen == fitting[0] ? fitting[1] : fitting[0];
    reason = "since by it the bones keep their lengths, and not by " + other->name;
  }
  return FoundNames{chosen->points,
                    {{"joint-order", 0,
                      "the joints have no names; the order " + chosen->name + " was guessed, " + reason}}};
}

Result<FoundNames> names_for(const NumpyFile& file, const std::optional<JointOrder>& order,
                             const StoredArray& positions) {
  const std::size_t joints = positions.layout.shape[1];
  if (order) {
    if (order->points.size() != joints)
      return Error{"has " + std::to_string(joints) + " joints; the order " + order->name + " has " +
                       std::to_string(order->points.size()),
                   file.place(positions)};
    return FoundNames{order->points, {}};
  }
  const StoredArray* array = file.find({"joint_names", "bone_names"});
  if (!array) return guess_order(file, positions);
  if (array->trouble) return *array->trouble;
  if (array->layout.is_number() || array->layout.shape.size() != 1 || array->layout.count() != joints)
    return Error{"expected a name for each of the " + std::to_string(joints) + " joints, found " +
                     (array->layout.is_number() ? "numbers of the shape " : "texts of the shape ") +
                     array->layout.shape_text(),
                 file.place(*array)};
  auto names = texts_in(file, *array);
  if (!names) return names.error();
  if (are_of_a_robot(*names))
    return Error{"has the names of a robot's parts (" + some_of(*names, 3) +
                     "), and a robot is no person; expected positions of a person's joints",
                 file.place(*array)};
  FoundNames found{std::move(*names), {}};
  for (const std::string& name : found.names)
    if (name.empty()) return Error{"has a joint without a name", file.place(*array)};
  make_names_unique(found.names, "joint", found.warnings);
  return found;
}

/// Which joint each hangs on, where the file says it of as many joints: -1 or one before it.
Result<std::vector<int>> parents_in(const NumpyFile& file, std::size_t joints) {
  const StoredArray* array = file.find({"parent_indices", "parents"});
  if (!array) return std::vector<int>(joints, -1);
  if (array->trouble) return *array->trouble;
  const Error expected{"expected for each of the " + std::to_string(joints) +
                           " joints the number of the one that it hangs on, which comes before it, or -1",
                       file.place(*array)};
  if (!array->layout.is_number() || array->layout.shape.size() != 1 || array->layout.count() != joints)
    return expected;
  const auto content = file.content_of(*array);
  if (!content) return content.error();
  const NpyArray numbers(array->layout, *content);
  std::vector<int> parents;
  for (std::size_t j = 0; j < joints; ++j) {
    const double parent = numbers.number(j);
    if (!(parent >= -1 && parent < static_cast<double>(j) && parent == std::floor(parent))) return expected;
    parents.push_back(static_cast<int>(parent));
  }
  return parents;
}

/// Nothing in a file is ignored silently.
void warn_of_unused(const NumpyFile& file, const std::vector<const StoredArray*>& persons,
                    NamedMotion& motion) {
  constexpr std::array<std::string_view, 13> honoured = {
      "joint_names",      "bone_names",      "framerate", "fps",     "frame_rate",
      "mocap_frame_rate", "mocap_framerate", "up",        "up_axis", "metres_per_unit",
      "positions",        "parent_indices",  "parents"};
  std::vector<std::string> unused;
  for (const StoredArray& array : file.arrays())
    if (std::ranges::find(honoured, array.name) == honoured.end() &&
        std::ranges::find(persons, &array) == persons.end())
      unused.push_back(array.name);
  if (!unused.empty()) motion.warnings.push_back({"arrays", 0, "not read: " + some_of(unused)});
}

/// A row of InterHuman (Liang et al., InterGen, IJCV 2024): places of 62 joints, then turns of 51. The first
/// 22 are the body's, as SMPL-X orders them; the others are of the hands.
constexpr std::uint64_t interhuman_columns = 62 * 3 + 51 * 6;

bool are_interhuman_rows(const StoredArray& array) {
  const auto& shape = array.layout.shape;
  return !array.trouble && array.layout.is_number() && shape.size() == 2 && shape[1] == interhuman_columns &&
         shape[0] > 0;
}

Result<NamedMotion> interhuman_motion(const NumpyFile& file, const StoredArray& array) {
  const auto content = file.content_of(array);
  if (!content) return content.error();
  const NpyArray rows(array.layout, *content);
  const auto order = find_joint_order("smplx22");
  if (!order) return order.error();
  NamedMotion motion;
  motion.name = array.name;
  motion.points = order->points;
  motion.parents.assign(motion.points.size(), -1);
  motion.metres_per_unit = 1.0;
  const std::uint64_t frames = array.layout.shape[0];
  for (std::uint64_t f = 0; f < frames; ++f) {
    Positions places(static_cast<Eigen::Index>(motion.points.size()), 3);
    for (Eigen::Index i = 0; i < places.size(); ++i) {
      const auto column = static_cast<std::uint64_t>(i);
      const double value =
          rows.number(array.layout.column_order ? column * frames + f : f * interhuman_columns + column);
      if (std::isinf(value))
        return Error{"frame " + std::to_string(f) + " (counted from 0) has an infinite position",
                     file.place(array)};
      places(i / 3, i % 3) = value;
    }
    motion.frames.push_back(std::move(places));
  }
  motion.warnings.push_back(
      {"joint-order", 0,
       "rows of 492 numbers were taken for InterHuman's: of its 62 joints the 22 of the body were "
       "read"});
  return motion;
}

}  // namespace

bool begins_as_npz(std::string_view head) {
  constexpr std::size_t name_at = 30;
  if (!head.starts_with("PK\x03\x04") || head.size() < name_at) return false;
  return head.substr(name_at, little_endian(head, 26, 2)).ends_with(".npy");
}

Result<std::vector<NamedMotion>> read_numpy(std::string_view bytes, const std::optional<JointOrder>& order,
                                            std::string_view where, const SmplBodyFile& body) {
  const auto file = NumpyFile::open(bytes, where);
  if (!file) return file.error();
  if (!body.where.empty()) {
    if (!holds_smpl_parameters(*file))
      return Error{"holds no parameters of an SMPL body (poses, trans, betas); leave out the body model",
                   file->where()};
    auto motion = read_smpl(*file, body);
    if (!motion) return motion.error();
    return std::vector<NamedMotion>{std::move(*motion)};
  }
  if (file->find({""}) && holds_smpl_parameters(*file)) return refuse_what_is_no_positions(*file).error();
  if (const StoredArray* rows = file->find({""}); rows && !order && are_interhuman_rows(*rows)) {
    auto motion = interhuman_motion(*file, *rows);
    if (!motion) return motion.error();
    return std::vector<NamedMotion>{std::move(*motion)};
  }
  const auto persons = arrays_of_performers(*file);
  if (!persons) return persons.error();
  const auto fps = number_in(*file, {"fps", "frame_rate", "framerate", "mocap_frame_rate", "mocap_framerate"},
                             "frames per second");
  if (!fps) return fps.error();
  const auto unit = number_in(*file, {"metres_per_unit"}, "metres per unit");
  if (!unit) return unit.error();
  const auto up = up_axis_in(*file);
  if (!up) return up.error();
  std::uint64_t numbers = 0;
  for (const StoredArray* person : *persons)
    numbers += std::min(person->layout.count(), limits::numpy_numbers + 1);
  if (persons->size() > 1 && numbers > limits::numpy_numbers)
    return Error{std::to_string(persons->size()) + " persons have more than " +
                     std::to_string(limits::numpy_numbers) +
                     " numbers together, which is as many as are read; write fewer frames at once",
                 file->where()};
  std::vector<NamedMotion> motions;
  for (const StoredArray* person : *persons) {
    const auto names = names_for(*file, order, *person);
    if (!names) return names.error();
    auto motion = motion_of(*file, *person, *names);
    if (!motion) return motion.error();
    motion->fps = *fps;
    motion->metres_per_unit = *unit;
    motion->up_axis = *up;
    auto parents = parents_in(*file, motion->points.size());
    if (!parents) return parents.error();
    motion->parents = std::move(*parents);
    warn_of_unused(*file, *persons, *motion);
    motions.push_back(std::move(*motion));
  }
  return motions;
}

}  // namespace abrazo
