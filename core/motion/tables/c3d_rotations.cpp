#include "core/motion/tables/c3d_rotations.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/text.hpp"
#include "core/motion/tables/point_rows.hpp"

namespace abrazo {

namespace {

constexpr std::size_t block_bytes = 512;
constexpr std::size_t floats_of_segment = 17;
constexpr std::size_t segment_bytes = 4 * floats_of_segment;
constexpr std::size_t highest_ratio = 10'000;
constexpr double loosest_axis = 0.01;  ///< single precision and a program's own rounding are far below

const C3dParameter* find_rotation(const C3dParameters& parameters, const std::string& name) {
  const auto found = parameters.find("ROTATION:" + name);
  return found == parameters.end() ? nullptr : &found->second;
}

std::size_t count_of(const C3dParameters& parameters, const std::string& name) {
  const C3dParameter* parameter = find_rotation(parameters, name);
  const double value = parameter ? parameter->count(0) : 0;
  return value >= 1 && value < 4.3e9 ? static_cast<std::size_t>(value) : 0;
}

std::vector<std::string> labels_of(const C3dParameters& parameters) {
  std::vector<std::string> labels;
  for (int n = 1; n < 300; ++n) {
    const C3dParameter* some =
        find_rotation(parameters, "LABELS" + (n == 1 ? std::string() : std::to_string(n)));
    if (!some) break;
    labels.insert(labels.end(), some->texts.begin(), some->texts.end());
  }
  return labels;
}

/// Theia3D keeps its own sizes in metres, lengths as texts.
std::vector<double> theia_metres(const C3dParameters& parameters, const std::string& name) {
  const auto found = parameters.find("THEIA3D:" + name);
  if (found == parameters.end()) return {};
  std::vector<double> metres = found->second.numbers;
  for (const std::string& text : found->second.texts)
    if (const auto number = parse_number(text)) metres.push_back(*number);
  constexpr double longest_m = 1;
  const bool usable = std::ranges::all_of(metres, [](double m) { return std::abs(m) < longest_m; });
  return usable ? metres : std::vector<double>();
}

double metres_per_unit(const C3dParameters& parameters) {
  const auto units = parameters.find("POINT:UNITS");
  if (units == parameters.end() || units->second.texts.empty()) return 0;
  return metres_of_unit(units->second.texts.front()).value_or(0);
}

}  // namespace

Result<std::optional<C3dRotations>> C3dRotations::announced(const C3dBytes& bytes,
                                                            const C3dParameters& parameters,
                                                            double point_rate, std::string_view where) {
  C3dRotations rotations(bytes, where);
  rotations.used_ = count_of(parameters, "USED");
  if (rotations.used_ == 0) return std::optional<C3dRotations>();
  const std::size_t first_block = count_of(parameters, "DATA_START");
  rotations.data_ = (std::max<std::size_t>(first_block, 1) - 1) * block_bytes;
  const std::size_t sample_bytes = rotations.used_ * segment_bytes;
  const auto error = [&](const std::string& message) {
    return Error{message, std::string(where) + ": ROTATION"};
  };
  if (first_block < 2 || rotations.data_ + sample_bytes > bytes.size())
    return error("the segments are said to begin at block " + std::to_string(first_block) +
                 ", where one sample of " + std::to_string(rotations.used_) + " takes " +
                 std::to_string(sample_bytes) + " bytes, and the file has " + std::to_string(bytes.size()) +
                 "; it is cut off, copy or export it again");
  rotations.samples_ = (bytes.size() - rotations.data_) / sample_bytes;
  const C3dParameter* rate = find_rotation(parameters, "RATE");
  rotations.rate_ = rate && !rate->numbers.empty() && rate->numbers[0] > 0 ? rate->numbers[0] : 0;
  rotations.ratio_ = std::max<std::size_t>(1, count_of(parameters, "RATIO"));
  if (!find_rotation(parameters, "RATIO") && rotations.rate_ > 0 && point_rate > 0)
    rotations.ratio_ = std::max<std::size_t>(
        1, static_cast<std::size_t>(std::llround(std::min(1e9, rotations.rate_ / point_rate))));
  if (rotations.ratio_ > highest_ratio)
    return error("there are said to be " + std::to_string(rotations.ratio_) +
                 " samples of the segments in a frame of points; expected 1 to " +
                 std::to_string(highest_ratio));
  if (rotations.rate_ == 0 && point_rate > 0)
    rotations.rate_ = point_rate * static_cast<double>(rotations.ratio_);
  rotations.announced_ = count_of(parameters, "FRAMES");
  if (rotations.announced_ > 0) rotations.samples_ = std::min(rotations.samples_, rotations.announced_);
  rotations.name_places(parameters);
  if (rotations.places_.empty())
    return error("none of its " + std::to_string(rotations.used_) +
                 " segments has a name (LABELS); export it again with them");
  return std::optional(std::move(rotations));
}

void C3dRotations::name_places(const C3dParameters& parameters) {
  const std::vector<std::string> labels = labels_of(parameters);
  for (std::size_t s = 0; s < used_; ++s)
    if (s < labels.size() && !labels[s].empty())
      places_.push_back({labels[s], s, Vec3::Zero()});
    else
      ++unnamed_;
  for (const std::string side : {"l", "r"}) {
    const std::string capital = side == "l" ? "L" : "R";
    // The length of a segment runs along -Z, that of the toes along Y.
    add_end(parameters, capital + "HAND_LENGTH", side + "_hand", side + "_hand_end", -Vec3::UnitZ());
    add_end(parameters, capital + "TOE_LENGTH", side + "_toes", side + "_toes_end", Vec3::UnitY());
  }
  add_end(parameters, "HEADCENTER_POS", "head", "head_center", Vec3::Zero());
}

/// @param direction of a length; zero for a parameter that is a place
void C3dRotations::add_end(const C3dParameters& parameters, const std::string& parameter,
                           const std::string& segment, const std::string& name, const Vec3& direction) {
  const double unit = metres_per_unit(parameters);
  const std::vector<double> metres = theia_metres(parameters, parameter);
  const std::size_t needed = direction.isZero() ? 3 : 1;
  if (unit <= 0 || metres.size() != needed) return;
  const auto found = std::ranges::find_if(
      places_, [&](const Place& place) { return lower_case(place.name) == segment + "_4x4"; });
  if (found == places_.end()) return;
  const Vec3 local = needed == 3 ? Vec3(metres[0], metres[1], metres[2]) : Vec3(metres[0] * direction);
  places_.push_back({name, found->segment, local / unit});
}

std::vector<std::string> C3dRotations::names() const {
  std::vector<std::string> names;
  for (const Place& place : places_) names.push_back(place.name);
  return names;
}

Result<Positions> C3dRotations::places(std::size_t sample) const {
  Positions positions(static_cast<Eigen::Index>(places_.size()), 3);
  for (std::size_t p = 0; p < places_.size(); ++p) {
    const std::size_t at = data_ + (sample * used_ + places_[p].segment) * segment_bytes;
    Eigen::Matrix4d transform;
    for (std::size_t i = 0; i < 16; ++i)
      transform.data()[i] = static_cast<double>(bytes_.real(at + 4 * i));  // by columns, as Eigen stores it
    const double reliability = static_cast<double>(bytes_.real(at + 64));
    auto place = positions.row(static_cast<Eigen::Index>(p));
    if (!transform.allFinite() || transform.topRows<3>().isZero(0) || reliability < 0) {
      place.setConstant(std::numeric_limits<double>::quiet_NaN());
      continue;
    }
    const Eigen::Matrix3d axes = transform.topLeftCorner<3, 3>();
    const bool has_last_row =
        (transform.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).cwiseAbs().maxCoeff() < 1e-3;
    if (!has_last_row || !(axes.transpose() * axes).isIdentity(loosest_axis) || axes.determinant() < 0)
      return Error{"the numbers of the segment " + in_quotes(places_[p].name) +
                       " are no transform; expected 16 by columns, perpendicular axes of length 1 and a last "
                       "row of 0 0 0 1, and one for the reliability. Export the file again",
                   where_ + ": sample " + std::to_string(sample)};
    place = (transform * places_[p].local.homogeneous()).head<3>().transpose();
  }
  return positions;
}

}  // namespace abrazo
