#include "core/motion/numpy/numpy_reader.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/base/available_memory.hpp"
#include "core/base/little_endian.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/numpy/npy_array.hpp"
#include "core/motion/numpy/zip_archive.hpp"

namespace abrazo {

namespace {

/// An array, read on demand: only used arrays of a .npz are read.
struct StoredArray {
  std::string name;  ///< empty in a .npy
  NpyLayout layout;
  const ZipEntry* entry = nullptr;
  std::optional<Error> trouble = {};  ///< why its elements are unreadable, if needed

  bool is_positions() const {
    return !trouble && layout.is_number() && layout.shape.size() == 3 && layout.shape[2] == 3;
  }
  std::string described() const {
    return (name.empty() ? "" : name + " ") + (trouble ? "(cannot be read)" : layout.shape_text());
  }
};

class NumpyFile {
 public:
  static Result<NumpyFile> open(std::string_view bytes, std::string_view where);

  const std::vector<StoredArray>& arrays() const { return arrays_; }
  const std::string& where() const { return where_; }
  const StoredArray* find(std::initializer_list<std::string_view> names) const {
    for (const std::string_view name : names)
      for (const StoredArray& array : arrays_)
        if (array.name == name) return &array;
    return nullptr;
  }
  bool has(std::string_view name) const { return find({name}) != nullptr; }
  std::string place(const StoredArray& array) const {
    return array.name.empty() ? where_ : where_ + ": " + array.name;
  }
  /// The bytes of the whole .npy, checked to hold all elements.
  Result<std::string> content_of(const StoredArray& array) const;
  std::string listed(std::size_t most) const;

 private:
  std::string_view bytes_;
  std::string where_;
  std::optional<ZipArchive> archive_;
  std::vector<StoredArray> arrays_;
};

Result<NumpyFile> NumpyFile::open(std::string_view bytes, std::string_view where) {
  NumpyFile file;
  file.bytes_ = bytes;
  file.where_ = where;
  if (!bytes.starts_with("PK")) {
    auto layout = parse_npy_header(bytes.substr(0, npy_header_most), where);
    if (!layout) return layout.error();
    file.arrays_.push_back({"", std::move(*layout)});
    return file;
  }
  auto archive = ZipArchive::open(bytes, where);
  if (!archive) return archive.error();
  file.archive_ = std::move(*archive);
  for (const ZipEntry& entry : file.archive_->entries()) {
    if (!entry.name.ends_with(".npy")) continue;
    StoredArray array{entry.name.substr(0, entry.name.size() - 4), {}, &entry};
    const auto head = file.archive_->beginning_of(entry, npy_header_most);
    if (!head) return head.error();
    auto layout = parse_npy_header(*head, file.place(array));
    if (layout)
      array.layout = std::move(*layout);
    else
      array.trouble = layout.error();
    file.arrays_.push_back(std::move(array));
  }
  if (file.arrays_.empty())
    return Error{"holds no arrays; expected positions (frames, joints, 3) in a .npy inside", file.where_};
  return file;
}

std::string NumpyFile::listed(std::size_t most) const {
  std::vector<std::string> names;
  for (const StoredArray& array : arrays_) names.push_back(array.described());
  return some_of(names, most);
}

Result<std::string> NumpyFile::content_of(const StoredArray& array) const {
  if (array.trouble) return *array.trouble;
  const std::uint64_t needed = array.layout.bytes();
  const std::uint64_t there = array.entry ? array.entry->size : bytes_.size();
  if (there < needed)
    return Error{"announces " + array.layout.shape_text() + " elements of " +
                     std::to_string(array.layout.item_bytes) + " bytes and holds " +
                     std::to_string(there - std::min<std::uint64_t>(there, array.layout.header_bytes)) +
                     " bytes of them; it is cut off, or its header is damaged",
                 place(array)};
  // What is inflated, and the doubles that come of it.
  const std::uint64_t free = available_memory_bytes();
  if (there > free / 4)
    return Error{"would take " + std::to_string(there >> 20U) + " MiB and as much again, and " +
                     std::to_string(free >> 20U) + " MiB of memory are free; write fewer frames at once",
                 place(array)};
  if (!array.entry) return std::string(bytes_);
  return archive_->content_of(*array.entry);
}

Result<std::optional<double>> number_in(const NumpyFile& file, std::initializer_list<std::string_view> names,
                                        std::string_view what) {
  const StoredArray* array = file.find(names);
  if (!array) return std::optional<double>();
  const Error expected{"expected " + std::string(what) + ": one number above 0", file.place(*array)};
  if (array->trouble) return *array->trouble;
  if (!array->layout.is_number() || array->layout.count() != 1) return expected;
  const auto content = file.content_of(*array);
  if (!content) return content.error();
  const double value = NpyArray(array->layout, *content).number(0);
  if (!std::isfinite(value) || value <= 0) return expected;
  return std::optional<double>(value);
}

Result<std::vector<std::string>> texts_in(const NumpyFile& file, const StoredArray& array) {
  const auto content = file.content_of(array);
  if (!content) return content.error();
  const NpyArray texts(array.layout, *content);
  std::vector<std::string> values;
  for (std::uint64_t i = 0; i < array.layout.count(); ++i) values.push_back(texts.text(i));
  return values;
}

Result<std::optional<UpAxis>> up_axis_in(const NumpyFile& file) {
  const StoredArray* array = file.find({"up", "up_axis"});
  if (!array) return std::optional<UpAxis>();
  const Error expected{R"(expected the axis that points up: the text "y" or "z")", file.place(*array)};
  if (array->trouble) return *array->trouble;
  if (array->layout.is_number() || array->layout.count() != 1) return expected;
  const auto texts = texts_in(file, *array);
  if (!texts) return texts.error();
  const std::string axis = lower_case(texts->front());
  if (axis != "y" && axis != "z") return expected;
  return std::optional<UpAxis>(axis == "z" ? UpAxis::Z : UpAxis::Y);
}

/// What a file without positions of joints is, as far as its arrays tell.
Status refuse_what_is_no_positions(const NumpyFile& file) {
  if ((file.has("poses") && file.has("trans")) || file.has("pose_body") || file.has("body_pose"))
    return Error{
        "holds the parameters of an SMPL body (poses, trans, betas), from which joints follow only with the "
        "body model, which is missing: it may not be shipped with Abrazo. Write the joints' positions "
        "(frames, joints, 3) with joint_names and fps by the program that has the model, or export FBX from "
        "Blender with the SMPL-X add-on",
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

Result<FoundNames> order_by_count(std::size_t joints, const std::string& where) {
  std::vector<const JointOrder*> fitting;
  for (const JointOrder& order : builtin_joint_orders())
    if (order.points.size() == joints) fitting.push_back(&order);
  const std::string says_it =
      "say which joint is which with --joints NAME|FILE, or with an array joint_names in a .npz";
  if (fitting.empty())
    return Error{std::to_string(joints) + " joints without names, and no known order has this number (" +
                     joint_order_names() + "); " + says_it,
                 where};
  if (fitting.size() > 1)
    return Error{std::to_string(joints) + " joints without names may be " + fitting[0]->name + " or " +
                     fitting[1]->name + "; " + says_it,
                 where};
  return FoundNames{fitting.front()->points,
                    {{"joint-order", 0,
                      "the joints have no names; the order " + fitting.front()->name +
                          " was guessed, since it alone has " + std::to_string(joints)}}};
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
  const StoredArray* array = file.find({"joint_names"});
  if (!array) return order_by_count(joints, file.place(positions));
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

/// Nothing in a file is ignored silently.
void warn_of_unused(const NumpyFile& file, const std::vector<const StoredArray*>& persons,
                    NamedMotion& motion) {
  constexpr std::array<std::string_view, 9> honoured = {
      "joint_names", "fps",     "frame_rate",      "mocap_frame_rate", "mocap_framerate",
      "up",          "up_axis", "metres_per_unit", "positions"};
  std::vector<std::string> unused;
  for (const StoredArray& array : file.arrays())
    if (std::ranges::find(honoured, array.name) == honoured.end() &&
        std::ranges::find(persons, &array) == persons.end())
      unused.push_back(array.name);
  if (!unused.empty()) motion.warnings.push_back({"arrays", 0, "not read: " + some_of(unused)});
}

}  // namespace

bool begins_as_npz(std::string_view head) {
  constexpr std::size_t name_at = 30;
  if (!head.starts_with("PK\x03\x04") || head.size() < name_at) return false;
  return head.substr(name_at, little_endian(head, 26, 2)).ends_with(".npy");
}

Result<std::vector<NamedMotion>> read_numpy(std::string_view bytes, const std::optional<JointOrder>& order,
                                            std::string_view where) {
  const auto file = NumpyFile::open(bytes, where);
  if (!file) return file.error();
  const auto persons = arrays_of_performers(*file);
  if (!persons) return persons.error();
  const auto fps =
      number_in(*file, {"fps", "frame_rate", "mocap_frame_rate", "mocap_framerate"}, "frames per second");
  if (!fps) return fps.error();
  const auto unit = number_in(*file, {"metres_per_unit"}, "metres per unit");
  if (!unit) return unit.error();
  const auto up = up_axis_in(*file);
  if (!up) return up.error();
  std::vector<NamedMotion> motions;
  for (const StoredArray* person : *persons) {
    const auto names = names_for(*file, order, *person);
    if (!names) return names.error();
    auto motion = motion_of(*file, *person, *names);
    if (!motion) return motion.error();
    motion->fps = *fps;
    motion->metres_per_unit = *unit;
    motion->up_axis = *up;
    warn_of_unused(*file, *persons, *motion);
    motions.push_back(std::move(*motion));
  }
  return motions;
}

}  // namespace abrazo
