#include "core/motion/numpy/smpl_body.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "core/base/limits.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/joint_order.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/numpy/numpy_file.hpp"

namespace abrazo {

namespace {

using Numbers = std::vector<double>;
using Shape = std::vector<std::uint64_t>;

constexpr std::size_t body_joints = 22, smpl_joints = 24, smplh_joints = 52, smplx_joints = 55;

struct Numeric {
  Shape shape;
  Numbers values;  ///< in C order
};

Result<Numeric> numbers_of(const NumpyFile& file, const StoredArray& array) {
  if (!array.trouble && !array.layout.is_number())
    return Error{"holds texts; expected numbers", file.place(array)};
  const auto content = file.content_of(array);
  if (!content) return content.error();
  const NpyArray numbers(array.layout, *content);
  const Shape& shape = array.layout.shape;
  Numeric result{shape, Numbers(array.layout.count())};
  for (std::uint64_t i = 0; i < result.values.size(); ++i) {
    std::uint64_t place = i;
    if (array.layout.column_order) {
      std::uint64_t left = i, stride = array.layout.count(), at = 0, column = 1;
      for (const std::uint64_t extent : shape) {
        stride /= extent;
        at += left / stride * column;
        left %= stride;
        column *= extent;
      }
      place = at;
    }
    result.values[i] = numbers.number(place);
  }
  return result;
}

/// The named array with that many dimensions; zero stands for any extent. @param names  any of them
Result<Numeric> array_of(const NumpyFile& file, std::initializer_list<std::string_view> names,
                         const Shape& shape, const std::string& expected) {
  const StoredArray* array = file.find(names);
  if (!array)
    return Error{
        "has no array " + std::string(*names.begin()) + " " + expected + "; it has " + file.listed(12),
        file.where()};
  const Shape& found = array->layout.shape;
  bool fits = array->trouble || found.size() == shape.size();
  for (std::size_t d = 0; fits && !array->trouble && d < shape.size(); ++d)
    fits = found[d] > 0 && (shape[d] == 0 || shape[d] == found[d]);
  if (!fits)
    return Error{"has the shape " + array->layout.shape_text() + "; expected " + expected,
                 file.place(*array)};
  return numbers_of(file, *array);
}

/// A body in its rest pose, for one shape.
struct RestBody {
  std::vector<int> parents;
  Positions joints;
};

/// The shapes of its arrays, before any of them is read: all of them follow from joints, vertices and shapes.
Status check_extents(const NumpyFile& file) {
  const auto bounded = [&](const char* name, std::size_t dimension, std::uint64_t most,
                           const char* what) -> Status {
    const StoredArray* array = file.find({name});
    if (!array || array->layout.shape.size() <= dimension || array->layout.shape[dimension] <= most)
      return Done{};
    return Error{"has the shape " + array->layout.shape_text() + "; body models of up to " +
                     std::to_string(most) + " " + what + " are read",
                 file.place(*array)};
  };
  if (const Status joints = bounded("J_regressor", 0, smplx_joints, "joints"); !joints) return joints;
  if (const Status vertices = bounded("J_regressor", 1, limits::body_vertices, "vertices"); !vertices)
    return vertices;
  return bounded("shapedirs", 2, limits::body_shapes, "shapes");
}

Result<RestBody> rest_body(const SmplBodyFile& source, const Numbers& betas) {
  const auto file = NumpyFile::open(source.bytes, source.where);
  if (!file) return file.error();
  if (const Status extents = check_extents(*file); !extents) return extents.error();
  const auto regressor = array_of(*file, {"J_regressor"}, {0, 0}, "(joints, vertices)");
  if (!regressor) return regressor.error();
  const std::uint64_t joints = regressor->shape[0], vertices = regressor->shape[1];
  const auto tree = array_of(*file, {"kintree_table"}, {2, joints}, "(2, " + std::to_string(joints) + ")");
  if (!tree) return tree.error();
  const auto vertex = array_of(*file, {"v_template"}, {vertices, 3}, "(" + std::to_string(vertices) + ", 3)");
  if (!vertex) return vertex.error();
  const auto shapes =
      array_of(*file, {"shapedirs"}, {vertices, 3, 0}, "(" + std::to_string(vertices) + ", 3, shapes)");
  if (!shapes) return shapes.error();
  const std::uint64_t shape_count = shapes->shape[2];
  if (betas.size() > shape_count)
    return Error{"has " + std::to_string(shape_count) + " shapes, and the motion " +
                     std::to_string(betas.size()) +
                     " betas; name the body model that the motion was made with",
                 source.where};
  RestBody body;
  body.joints = Positions::Zero(static_cast<Eigen::Index>(joints), 3);
  for (std::uint64_t j = 0; j < joints; ++j) {
    const double parent = tree->values[j];
    if (j > 0 && !(parent >= 0 && parent < static_cast<double>(j) && parent == std::floor(parent)))
      return Error{"joint " + std::to_string(j) + " has a parent that is no joint before it",
                   source.where + ": kintree_table"};
    body.parents.push_back(j == 0 ? -1 : static_cast<int>(parent));
    for (std::uint64_t v = 0; v < vertices; ++v) {
      const double weight = regressor->values[j * vertices + v];
      if (weight == 0) continue;
      for (std::uint64_t axis = 0; axis < 3; ++axis) {
        double place = vertex->values[3 * v + axis];
        for (std::size_t b = 0; b < betas.size(); ++b)
          place += shapes->values[(3 * v + axis) * shape_count + b] * betas[b];
        body.joints(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(axis)) += weight * place;
      }
    }
  }
  if (!body.joints.allFinite()) return Error{"has places of joints that are no numbers", source.where};
  return body;
}

/// A row of Motion-X (Lin et al., NeurIPS 2023): SMPL-X's angles of root, body, hands and jaw, the face's
/// expression and shape, the place and the betas.
constexpr std::uint64_t motionx_columns = 322, motionx_trans = 309, motionx_betas = 312;
constexpr double motionx_fps = 30;

const StoredArray* motionx_rows(const NumpyFile& file) {
  const StoredArray* rows = file.find({""});
  const bool is_one = rows && !rows->trouble && rows->layout.is_number() && rows->layout.shape.size() == 2 &&
                      rows->layout.shape[1] == motionx_columns && rows->layout.shape[0] > 0;
  return is_one ? rows : nullptr;
}

/// `width` columns of each row of Motion-X, from `first` on.
Result<Numeric> motionx_part(const NumpyFile& file, std::uint64_t first, std::uint64_t width) {
  const auto rows = numbers_of(file, *motionx_rows(file));
  if (!rows) return rows.error();
  const std::uint64_t frames = rows->shape[0];
  Numeric part{{frames, width}, Numbers(frames * width)};
  for (std::uint64_t f = 0; f < frames; ++f)
    std::copy_n(rows->values.begin() + static_cast<std::ptrdiff_t>(f * motionx_columns + first), width,
                part.values.begin() + static_cast<std::ptrdiff_t>(f * width));
  return part;
}

/// Betas of the whole motion; where they are given for each frame, those of the first.
Result<Numbers> betas_of(const NumpyFile& file) {
  if (motionx_rows(file)) {
    auto all = motionx_part(file, motionx_betas, motionx_columns - motionx_betas);
    if (all) all->values.resize(motionx_columns - motionx_betas);
    return all ? Result<Numbers>(std::move(all->values)) : Result<Numbers>(all.error());
  }
  const StoredArray* array = file.find({"betas", "beta", "shape"});
  if (!array) return Numbers();
  auto betas = numbers_of(file, *array);
  if (!betas) return betas.error();
  if (betas->shape.empty() || betas->shape.size() > 2 || betas->values.size() < betas->shape.back())
    return Error{"has the shape " + array->layout.shape_text() + "; expected (betas,) or (frames, betas)",
                 file.place(*array)};
  betas->values.resize(betas->shape.back());
  for (const double beta : betas->values)
    if (!std::isfinite(beta)) return Error{"has a beta that is no number", file.place(*array)};
  return betas->values;
}

/// The angles of all joints of the body [frames x 3 J], put together where the file has them in parts.
Result<Numeric> poses_of(const NumpyFile& file, std::size_t joints) {
  const std::string wanted = "(frames, " + std::to_string(3 * joints) + ")";
  if (file.has("poses")) {
    auto poses = array_of(file, {"poses"}, {0, 0}, wanted);
    if (poses && poses->shape[1] != 3 * joints)
      return Error{"has the shape (" + std::to_string(poses->shape[0]) + ", " +
                       std::to_string(poses->shape[1]) + "): angles of " +
                       std::to_string(poses->shape[1] / 3) + " joints, and the body model has " +
                       std::to_string(joints) +
                       "; name the one that the motion was made with (SMPL 24, SMPL-H 52, " + "SMPL-X 55)",
                   file.where() + ": poses"};
    return poses;
  }
  const bool is_motionx = motionx_rows(file) != nullptr;
  auto root = is_motionx ? motionx_part(file, 0, 3)
                         : array_of(file, {"root_orient", "global_orient"}, {0, 3}, "(frames, 3)");
  if (!root) return root.error();
  const std::uint64_t frames = root->shape[0];
  Numeric poses{{frames, 3 * joints}, Numbers(frames * 3 * joints, 0.0)};
  const auto put = [&](const Numeric& part, std::size_t first) {
    const std::size_t width = std::min<std::size_t>(part.shape[1], 3 * (joints - first));
    for (std::uint64_t f = 0; f < frames; ++f)
      std::copy_n(part.values.begin() + static_cast<std::ptrdiff_t>(f * part.shape[1]), width,
                  poses.values.begin() + static_cast<std::ptrdiff_t>((f * joints + first) * 3));
  };
  put(*root, 0);
  auto body = is_motionx ? motionx_part(file, 3, 63)
                         : array_of(file, {"pose_body", "body_pose"}, {frames, 0}, "(frames, 63)");
  if (!body) return body.error();
  // SMPL itself counts the hands as two joints of the body.
  if (const std::uint64_t width = body->shape[1]; width != 63 && !(width == 69 && joints == smpl_joints))
    return Error{"has angles of " + std::to_string(width) +
                     " columns; expected 63, three for each of 21 joints" +
                     (joints == smpl_joints ? ", or 69 with those of the hands" : ""),
                 file.place(*file.find({"pose_body", "body_pose"}))};
  put(*body, 1);
  const std::size_t hands = joints == smplx_joints ? 25 : body_joints;
  for (const auto& [first, name, other] : {std::tuple(hands, "pose_lhand", "left_hand_pose"),
                                           std::tuple(hands + 15, "pose_rhand", "right_hand_pose")}) {
    if (joints < smplh_joints || !file.find({name, other})) continue;
    // Fewer columns are components of a space of hands, which only the body model's own program knows.
    const auto hand = array_of(file, {name, other}, {frames, 45}, "(frames, 45)");
    if (!hand) return hand.error();
    put(*hand, first);
  }
  return poses;
}

std::vector<std::string> joint_names_of(std::size_t joints) {
  std::vector<std::string> names;
  for (const JointOrder& order : builtin_joint_orders())
    if (order.name == "smplx22") names = order.points;
  if (joints == smpl_joints) names.insert(names.end(), {"L_Hand", "R_Hand"});
  if (joints == smplx_joints) names.insert(names.end(), {"Jaw", "L_Eye", "R_Eye"});
  if (joints >= smplh_joints)
    for (const std::string side : {"L_", "R_"})
      for (const std::string finger : {"Index", "Middle", "Pinky", "Ring", "Thumb"})
        for (const char* part : {"1", "2", "3"}) names.push_back(side + finger + part);
  return names;
}

Eigen::Matrix3d turn_by(const Vec3& angle_axis) {
  const double angle = angle_axis.norm();
  if (!(angle > 0)) return Eigen::Matrix3d::Identity() * (angle == 0 ? 1.0 : angle);
  return Eigen::AngleAxisd(angle, angle_axis / angle).toRotationMatrix();
}

}  // namespace

bool holds_smpl_parameters(const NumpyFile& file) {
  return motionx_rows(file) || (file.has("poses") && file.has("trans")) || file.has("pose_body") ||
         file.has("body_pose");
}

Result<NamedMotion> read_smpl(const NumpyFile& file, const SmplBodyFile& source) {
  const auto betas = betas_of(file);
  if (!betas) return betas.error();
  const auto body = rest_body(source, *betas);
  if (!body) return body.error();
  const auto joints = static_cast<std::size_t>(body->joints.rows());
  NamedMotion motion;
  motion.points = joint_names_of(joints);
  if (motion.points.size() != joints)
    return Error{"has " + std::to_string(joints) +
                     " joints; expected the 24 of SMPL, the 52 of SMPL-H or the 55 of "
                     "SMPL-X",
                 source.where};
  const auto poses = poses_of(file, joints);
  if (!poses) return poses.error();
  const std::uint64_t frames = poses->shape[0];
  const bool is_motionx = motionx_rows(file) != nullptr;
  const auto trans =
      is_motionx ? motionx_part(file, motionx_trans, 3)
                 : array_of(file, {"trans", "transl"}, {frames, 3}, "(" + std::to_string(frames) + ", 3)");
  if (!trans) return trans.error();
  const auto fps =
      number_in(file, {"fps", "frame_rate", "mocap_frame_rate", "mocap_framerate"}, "frames per second");
  if (!fps) return fps.error();
  motion.name = "smpl";
  motion.parents = body->parents;
  motion.fps = is_motionx ? motionx_fps : *fps;
  motion.metres_per_unit = 1.0;
  for (std::uint64_t f = 0; f < frames; ++f) {
    Positions places(body->joints.rows(), 3);
    std::vector<Eigen::Matrix3d> turns(joints);
    for (std::size_t j = 0; j < joints; ++j) {
      const auto row = static_cast<Eigen::Index>(j);
      const double* angles = &poses->values[(f * joints + j) * 3];
      const Eigen::Matrix3d turn = turn_by(Vec3(angles[0], angles[1], angles[2]));
      if (j == 0) {
        const double* root = &trans->values[f * 3];
        turns[0] = turn;
        places.row(0) = body->joints.row(0) + Eigen::RowVector3d(root[0], root[1], root[2]);
        continue;
      }
      const auto parent = static_cast<std::size_t>(body->parents[j]);
      const auto above = static_cast<Eigen::Index>(parent);
      turns[j] = turns[parent] * turn;
      places.row(row) =
          places.row(above) +
          (turns[parent] * (body->joints.row(row) - body->joints.row(above)).transpose()).transpose();
    }
    if (!places.allFinite())
      return Error{
          "frame " + std::to_string(f) + " (counted from 0) has a parameter that is no number; leave it out",
          file.where()};
    motion.frames.push_back(std::move(places));
  }
  std::string gender;
  if (const StoredArray* array = file.find({"gender"});
      array && !array->trouble && !array->layout.is_number())
    if (const auto texts = texts_in(file, *array); texts && !texts->empty())
      gender = "; the motion was made with a body of gender " + in_quotes(texts->front()) +
               ", which the model must be";
  motion.warnings.push_back({"body-model", 0,
                             "joints were computed from SMPL parameters with " +
                                 std::to_string(betas->size()) + " betas and the body model " + source.where +
                                 gender});
  return motion;
}

}  // namespace abrazo
