#include "core/motion/tables/c3d_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "core/base/line_reader.hpp"
#include "core/base/text.hpp"
#include "core/motion/joints/performers.hpp"
#include "core/motion/tables/c3d_parameters.hpp"
#include "core/motion/tables/c3d_rotations.hpp"
#include "core/motion/tables/point_rows.hpp"

namespace abrazo {

namespace {

constexpr std::size_t block = 512;

class C3dParser {
 public:
  C3dParser(std::string_view bytes, std::string_view where)
      : raw_(bytes), where_(where), bytes_(bytes, C3dProcessor::Intel) {}
  Result<std::vector<NamedMotion>> parse();

 private:
  Status read_header();
  Status find_rotations();
  Status measure();
  Status measure_rotations();
  std::size_t declared_frames();
  std::vector<std::string> labels();
  std::set<std::string> modelled() const;
  void choose_points();
  double point_rate() const;
  Status read_frames();
  Status read_rotations(std::size_t frame, Positions& places) const;
  Vec3 point(std::size_t at, bool& seen) const;
  void settle_unit();
  void settle_axes();
  std::vector<std::string> label_prefixes() const;
  const C3dParameter* find(const std::string& name) const {
    const auto found = parameters_.find(name);
    return found == parameters_.end() ? nullptr : &found->second;
  }
  void warn(std::string kind, std::string detail) {
    motion_.warnings.push_back({std::move(kind), 0, std::move(detail)});
  }
  void warn_of_end(std::size_t declared) {
    warn("frame-count", "the file announces " + std::to_string(declared) + " frames and ends after " +
                            std::to_string(frames_) + "; those were read");
  }
  Error error(std::string message, std::size_t byte) const {
    return Error{std::move(message), where_ + ": byte " + std::to_string(byte)};
  }

  std::string_view raw_;
  std::string where_;
  C3dBytes bytes_;
  C3dParameters parameters_;
  NamedMotion motion_;
  std::size_t points_ = 0, analog_ = 0, frames_ = 0;  ///< `analog_`: values per frame
  std::size_t data_ = 0, frame_bytes_ = 0;
  double scale_ = 1;  ///< of integers
  bool is_float_ = false;
  std::vector<std::size_t> chosen_;  ///< points with a label
  std::optional<C3dRotations> rotations_;
};

Status C3dParser::read_header() {
  if (raw_.size() < block)
    return error(
        "has " + std::to_string(raw_.size()) +
            " bytes; a C3D file has at least its header of 512. It is cut off; copy or export it again",
        raw_.size());
  if (bytes_.byte(1) != 0x50)
    return error(
        "expected the key of C3D, 80, found " + std::to_string(bytes_.byte(1)) + "; this is no C3D file", 1);
  const std::size_t section = bytes_.byte(0) == 0 ? block : (bytes_.byte(0) - 1) * block;
  if (section + 4 > raw_.size() || section == 0)
    return error("the parameters are said to begin at block " + std::to_string(bytes_.byte(0)) +
                     ", and the file has " + std::to_string(raw_.size() / block),
                 0);
  const int processor = bytes_.byte(section + 3);
  if (processor < 84 || processor > 86)
    return error("expected the type of processor, 84 (Intel), 85 (DEC) or 86 (MIPS), found " +
                     std::to_string(processor) + "; the file is damaged or no C3D file",
                 section + 3);
  bytes_ = C3dBytes(raw_, static_cast<C3dProcessor>(processor));
  points_ = bytes_.word(2);
  analog_ = bytes_.word(4);
  const std::size_t data_block = bytes_.word(16);
  data_ = data_block == 0 ? 0 : (data_block - 1) * block;
  const std::size_t blocks = bytes_.byte(section + 2);
  const std::size_t end = data_ > section ? data_ : section + std::max<std::size_t>(blocks, 1) * block;
  Result<C3dParameters> parameters = parse_c3d_parameters(bytes_, section, end, where_, motion_.warnings);
  if (!parameters) return parameters.error();
  parameters_ = std::move(*parameters);
  return find_rotations();
}

Status C3dParser::find_rotations() {
  Result<std::optional<C3dRotations>> rotations =
      C3dRotations::announced(bytes_, parameters_, point_rate(), where_);
  if (!rotations) return rotations.error();
  rotations_ = std::move(*rotations);
  return Done{};
}

/// The header counts to 65535; the parameters can exceed it.
std::size_t C3dParser::declared_frames() {
  const auto whole = [](double value) {
    return value > 0 && value < 4.3e9 ? static_cast<std::size_t>(value) : 0;
  };
  const C3dParameter* begin = find("TRIAL:ACTUAL_START_FIELD");
  const C3dParameter* end = find("TRIAL:ACTUAL_END_FIELD");
  if (begin && end && begin->numbers.size() >= 2 && end->numbers.size() >= 2) {
    const double first = begin->count(0) + 65536 * begin->count(1),
                 last = end->count(0) + 65536 * end->count(1);
    if (last >= first) return whole(last - first + 1);
  }
  if (const C3dParameter* frames = find("POINT:LONG_FRAMES"); frames && whole(frames->count(0)) > 0)
    return whole(frames->count(0));
  const std::size_t first = bytes_.word(6), last = bytes_.word(8);
  const std::size_t in_header = last >= first ? last - first + 1 : 0;
  const C3dParameter* frames = find("POINT:FRAMES");
  const std::size_t in_parameters = frames ? whole(frames->count(0)) : 0;
  if (last == 65535 && in_parameters <= in_header)
    return std::numeric_limits<std::size_t>::max();  // all there are
  return std::max(in_header, in_parameters);
}

/// A file of segments alone: each sample is a frame.
Status C3dParser::measure_rotations() {
  const std::size_t frames = declared_frames();
  const bool says_all = frames == std::numeric_limits<std::size_t>::max();
  const std::size_t declared = rotations_->announced() > 0 ? rotations_->announced()
                               : says_all                  ? 0
                                                           : frames * rotations_->ratio();
  frames_ = declared > 0 ? std::min(rotations_->samples(), declared) : rotations_->samples();
  if (frames_ < declared) warn_of_end(declared);
  return Done{};
}

Status C3dParser::measure() {
  if (points_ == 0 && rotations_) return measure_rotations();
  if (points_ == 0)
    return error("has no markers (the header says 0 points) and no segments; export it with its trajectories",
                 2);
  const C3dParameter* scale = find("POINT:SCALE");
  scale_ = static_cast<double>(bytes_.real(12));
  if (scale && !scale->numbers.empty() && scale->numbers[0] != 0) scale_ = scale->numbers[0];
  if (scale_ == 0 || !std::isfinite(scale_))
    return error("the scale of the points is " + exact_text(scale_) +
                     "; expected a factor above 0 for integers, or one below 0 for floats",
                 12);
  is_float_ = scale_ < 0;
  if (const C3dParameter* start = find("POINT:DATA_START"); data_ == 0 && start && start->count(0) > 1)
    data_ = static_cast<std::size_t>(start->count(0) - 1) * block;
  if (data_ < block || data_ >= raw_.size())
    return error("the markers are said to begin at byte " + std::to_string(data_) + ", and the file has " +
                     std::to_string(raw_.size()) + "; it is cut off, copy or export it again",
                 16);
  const std::size_t width = is_float_ ? 4 : 2;
  frame_bytes_ = (4 * points_ + analog_) * width;
  const std::size_t there = (raw_.size() - data_) / frame_bytes_;
  const std::size_t declared = declared_frames();
  frames_ = std::min(declared, there);
  if (there == 0)
    return error("ends inside the first frame, which takes " + std::to_string(frame_bytes_) + " bytes",
                 raw_.size());
  if (declared == 0)
    return error("has no frames (first " + std::to_string(bytes_.word(6)) + ", last " +
                     std::to_string(bytes_.word(8)) + ")",
                 6);
  if (frames_ < declared && declared != std::numeric_limits<std::size_t>::max()) warn_of_end(declared);
  return Done{};
}

std::vector<std::string> C3dParser::labels() {
  std::vector<std::string> all;
  for (int n = 1; n < 300; ++n) {
    const C3dParameter* labels = find("POINT:LABELS" + (n == 1 ? std::string() : std::to_string(n)));
    if (!labels) break;
    all.insert(all.end(), labels->texts.begin(), labels->texts.end());
  }
  if (all.size() > points_) all.resize(points_);
  return all;
}

/// Names of points that are no places: a model's angles, forces, moments and powers.
std::set<std::string> C3dParser::modelled() const {
  std::set<std::string> names;
  for (const char* kind : {"ANGLES", "FORCES", "MOMENTS", "POWERS", "SCALARS", "REACTIONS"})
    for (const std::string& number : {std::string(), std::string("2"), std::string("3")})
      if (const C3dParameter* group = find("POINT:" + std::string(kind) + number))
        names.insert(group->texts.begin(), group->texts.end());
  return names;
}

void C3dParser::choose_points() {
  const std::vector<std::string> names = labels();
  const std::set<std::string> no_places = modelled();
  std::size_t unlabelled = points_ - names.size(), computed = 0;
  for (std::size_t p = 0; p < names.size(); ++p) {
    if (names[p].empty() || names[p].front() == '*') {
      ++unlabelled;
    } else if (no_places.contains(names[p])) {
      ++computed;
    } else {
      chosen_.push_back(p);
      motion_.points.push_back(names[p]);
      motion_.parents.push_back(-1);
    }
  }
  if (rotations_) {
    for (const std::string& name : rotations_->names())
      motion_.points.push_back(name), motion_.parents.push_back(-1);
    if (rotations_->unnamed() > 0)
      warn("unlabelled", std::to_string(rotations_->unnamed()) + " segments have no name and were left out");
  }
  make_names_unique(motion_.points, "point", motion_.warnings);
  if (unlabelled > 0)
    warn("unlabelled", std::to_string(unlabelled) + " of " + std::to_string(points_) +
                           " trajectories have no name and were left out");
  if (computed > 0)
    warn("computed",
         std::to_string(computed) + " angles, forces and the like, which are no places, were left out");
}

Vec3 C3dParser::point(std::size_t at, bool& seen) const {
  Vec3 place;
  double residual = 0;
  if (is_float_) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[static_cast<Eigen::Index>(axis)] = static_cast<double>(bytes_.real(at + 4 * axis));
    residual = static_cast<double>(bytes_.real(at + 12));
  } else {
    for (std::size_t axis = 0; axis < 3; ++axis)
      place[static_cast<Eigen::Index>(axis)] = scale_ * bytes_.integer(at + 2 * axis);
    residual = bytes_.integer(at + 6);
  }
  seen = !(residual < 0) && place.allFinite() && !place.isZero(0);
  return place;
}

double C3dParser::point_rate() const {
  const C3dParameter* rate = find("POINT:RATE");
  double fps = rate && !rate->numbers.empty() ? rate->numbers[0] : 0;
  if (!(fps > 0) || !std::isfinite(fps)) fps = static_cast<double>(bytes_.real(20));
  return fps > 0 && std::isfinite(fps) ? fps : 0;
}

/// Segments may be sampled several times in a frame of points: the first is at its time.
Status C3dParser::read_rotations(std::size_t frame, Positions& places) const {
  const auto own = static_cast<Eigen::Index>(motion_.points.size() - chosen_.size());
  const std::size_t sample = points_ > 0 ? frame * rotations_->ratio() : frame;
  if (sample >= rotations_->samples()) {
    places.bottomRows(own).setConstant(std::numeric_limits<double>::quiet_NaN());
    return Done{};
  }
  const Result<Positions> found = rotations_->places(sample);
  if (!found) return found.error();
  places.bottomRows(own) = *found;
  return Done{};
}

Status C3dParser::read_frames() {
  const std::size_t width = is_float_ ? 4 : 2;
  motion_.frames.reserve(frames_);
  for (std::size_t f = 0; f < frames_; ++f) {
    Positions& frame = motion_.frames.emplace_back(static_cast<Eigen::Index>(motion_.points.size()), 3);
    for (std::size_t c = 0; c < chosen_.size(); ++c) {
      bool seen = false;
      const Vec3 place = point(data_ + f * frame_bytes_ + chosen_[c] * 4 * width, seen);
      const auto row = static_cast<Eigen::Index>(c);
      if (seen)
        frame.row(row) = place.transpose();
      else
        frame.row(row).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    if (!rotations_) continue;
    if (const Status read = read_rotations(f, frame); !read) return read.error();
  }
  const double fps = points_ == 0 && rotations_->rate() > 0 ? rotations_->rate() : point_rate();
  if (fps > 0) motion_.fps = fps;
  return Done{};
}

void C3dParser::settle_unit() {
  const C3dParameter* units = find("POINT:UNITS");
  const std::string word = units && !units->texts.empty() ? units->texts.front() : std::string();
  motion_.metres_per_unit = metres_of_unit(word);
  if (!word.empty() && !motion_.metres_per_unit)
    warn("unit", "the unit " + in_quotes(word) + " is not known");
}

/// Y_SCREEN is the axis that a program shows upwards: +Z, Y, -Z, ... It says how the capture was looked at;
/// import_clip compares it with the people.
void C3dParser::settle_axes() {
  const C3dParameter* screen = find("POINT:Y_SCREEN");
  std::string axis = screen && !screen->texts.empty() ? lower_case(screen->texts.front()) : std::string();
  if (axis.starts_with('+')) axis.erase(0, 1);
  motion_.up_axis = find_up_axis(axis);
}

std::vector<std::string> C3dParser::label_prefixes() const {
  std::vector<std::string> prefixes;
  if (const C3dParameter* given = find("SUBJECTS:LABEL_PREFIXES")) prefixes = given->texts;
  if (const C3dParameter* names = find("SUBJECTS:NAMES"))
    for (const std::string& name : names->texts)
      if (!name.empty()) prefixes.push_back(name + "_");
  std::erase(prefixes, "");
  return prefixes;
}

Result<std::vector<NamedMotion>> C3dParser::parse() {
  if (const Status header = read_header(); !header) return header.error();
  if (const Status measured = measure(); !measured) return measured.error();
  choose_points();
  if (motion_.points.empty())
    return Error{"none of its " + std::to_string(points_) +
                     " trajectories has a name; label them in the capturing program and export again",
                 where_};
  if (const Status read = read_frames(); !read) return read.error();
  settle_unit();
  settle_axes();
  motion_.name = stem_of(where_);
  return split_performers(std::move(motion_), ":", label_prefixes());
}

}  // namespace

Result<std::vector<NamedMotion>> read_c3d(std::string_view bytes, std::string_view where) {
  return C3dParser(bytes, where).parse();
}

}  // namespace abrazo
