#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/base/line_reader.hpp"
#include "core/base/text.hpp"
#include "core/base/units.hpp"
#include "core/motion/bvh/bvh.hpp"
#include "core/motion/bvh/bvh_hierarchy.hpp"

namespace abrazo {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// How often something odd was seen, and where first.
struct Sighting {
  std::size_t count = 0;
  int first_line = 0;
  void note(int line) {
    if (count++ == 0) first_line = line;
  }
};

/// Cuts numbers off a row. Knows what writers in the wild do: numbers without a blank between ("0.0-7.50"),
/// decimal commas ("0,5"), commas as separators ("0.5, 1.5").
class RowScanner {
 public:
  RowScanner(std::string_view row, int line, Sighting& glued, Sighting& commas)
      : at_(row.data()), end_(row.data() + row.size()), line_(line), glued_(glued), commas_(commas) {}

  /// @return false at the end of the row
  bool more() {
    while (at_ != end_ && is_blank(*at_)) ++at_;
    return at_ != end_;
  }

  /// The next number, which may be NaN; none if there is no number.
  std::optional<double> next() {
    const char* begin = *at_ == '+' ? at_ + 1 : at_;
    double value = 0;
    const char* stop = parse(begin, end_, value);
    if (stop == nullptr) return std::nullopt;
    if (stop != end_ && *stop == ',') stop = after_comma(begin, stop, value);
    if (stop != end_ && (*stop == '-' || *stop == '+'))
      glued_.note(line_);
    else if (stop != end_ && !is_blank(*stop) && *(stop - 1) != ',')
      return std::nullopt;
    at_ = stop;
    return value;
  }

  /// The text found instead of a number.
  std::string_view word() const {
    std::string_view rest(at_, static_cast<std::size_t>(end_ - at_));
    return take_word(rest);
  }

 private:
  static const char* parse(const char* begin, const char* end, double& value) {
    const auto [stop, failure] = std::from_chars(begin, end, value);
    if (failure == std::errc::invalid_argument) return nullptr;
    if (failure == std::errc::result_out_of_range) {
      const bool tiny =
          std::search_n(begin, stop, 1, '-', [](char c, char minus) { return c == minus; }) != stop &&
          std::find_if(begin, stop, [](char c) { return c == 'e' || c == 'E'; }) != stop;
      value = tiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    return stop;
  }

  /// @return position after a decimal comma and its digits, or after a separating comma
  const char* after_comma(const char* begin, const char* comma, double& value) {
    commas_.note(line_);
    const bool has_point =
        std::find_if(begin, comma, [](char c) { return c == '.' || c == 'e' || c == 'E'; }) != comma;
    if (has_point || comma + 1 == end_ || !is_digit(comma[1])) return comma + 1;
    std::string with_point(begin, std::min(end_, comma + 40));
    with_point[static_cast<std::size_t>(comma - begin)] = '.';
    const char* stop = parse(with_point.data(), with_point.data() + with_point.size(), value);
    return begin + (stop - with_point.data());
  }

  const char* at_;
  const char* end_;
  int line_;
  Sighting& glued_;
  Sighting& commas_;
};

/// rotation * turn about an axis (0, 1, 2), by columns: the reader spends its time here.
void turn_about(Eigen::Matrix3d& rotation, int axis, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  const int next = (axis + 1) % 3, after = (axis + 2) % 3;
  const Vec3 a = rotation.col(next), b = rotation.col(after);
  rotation.col(next) = c * a + s * b;
  rotation.col(after) = c * b - s * a;
}

/// World positions of all nodes for one row. A position channel replaces that coordinate of the OFFSET;
/// rotations apply in the order of their channels, regardless of position channels.
void place_nodes(const std::vector<BvhNode>& nodes, const std::vector<double>& row,
                 std::vector<Eigen::Matrix3d>& world, Positions& places) {
  std::size_t value = 0;
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const BvhNode& node = nodes[n];
    Vec3 offset = node.offset;
    if (node.parent < 0)
      world[n].setIdentity();
    else
      world[n] = world[static_cast<std::size_t>(node.parent)];
    const Eigen::Matrix3d parent = world[n];
    for (const BvhChannel channel : node.channels) {
      if (channel < 3)
        offset[channel] = row[value++];
      else
        turn_about(world[n], channel - 3, row[value++] * radians_per_degree);
    }
    const auto r = static_cast<Eigen::Index>(n);
    places.row(r) = (parent * offset).transpose();
    if (node.parent >= 0) places.row(r) += places.row(node.parent);
  }
}

class MotionParser {
 public:
  MotionParser(LineReader& lines, std::string_view where, BvhHierarchy hierarchy)
      : lines_(lines), where_(where), hierarchy_(std::move(hierarchy)) {}

  Result<std::vector<NamedMotion>> parse();

 private:
  void split_roots();
  /// @return true when the line belonged to the header
  Result<bool> read_header(std::string_view line);
  Status read_row(std::string_view line);
  Error bad_value(std::size_t index, const std::string& found) const;
  void append_frame();
  std::optional<double> settle_rate();
  void report_oddities();
  void warn(std::string kind, int line, std::string detail) {
    hierarchy_.warnings.push_back({std::move(kind), line, std::move(detail)});
  }
  Error error(std::string message) const { return error_at(where_, lines_.number(), std::move(message)); }

  LineReader& lines_;
  std::string where_;
  BvhHierarchy hierarchy_;
  std::vector<NamedMotion> motions_;
  std::vector<Eigen::Index> first_nodes_;  ///< of each root
  std::optional<long long> declared_frames_;
  int frames_line_ = 0;
  std::optional<double> frame_time_s_;
  int frame_time_line_ = 0;
  std::size_t frames_ = 0;
  std::vector<double> row_;
  std::vector<Eigen::Matrix3d> world_;
  Positions places_;
  Sighting glued_, commas_;
};

/// "walk:Hips" -> "walk", "Hips" -> "Hips".
std::string performer_name(const std::string& root) {
  const auto colon = root.rfind(':');
  return colon == std::string::npos || colon == 0 ? root : root.substr(0, colon);
}

void MotionParser::split_roots() {
  std::set<std::string> names;
  for (std::size_t n = 0; n < hierarchy_.nodes.size(); ++n) {
    const BvhNode& node = hierarchy_.nodes[n];
    if (node.parent < 0) {
      first_nodes_.push_back(static_cast<Eigen::Index>(n));
      std::string name = performer_name(node.name);
      for (int count = 2; !names.insert(name).second; ++count)
        name = performer_name(node.name) + "_" + std::to_string(count);
      motions_.emplace_back();
      motions_.back().name = name;
    }
    motions_.back().points.push_back(node.name);
    motions_.back().parents.push_back(node.parent < 0 ? -1
                                                      : node.parent - static_cast<int>(first_nodes_.back()));
  }
  world_.resize(hierarchy_.nodes.size());
  places_.resize(static_cast<Eigen::Index>(hierarchy_.nodes.size()), 3);
}

Result<bool> MotionParser::read_header(std::string_view line) {
  const auto colon = line.find(':');
  const std::string_view label_end = line.substr(0, colon);
  const auto words = split_words(label_end);
  if (words.empty() || lower_case(words[0]).rfind("frame", 0) != 0) return false;
  const bool is_time =
      lower_case(words.back()) == "time" || (words.size() > 1 && lower_case(words[1]) == "time");
  std::string value(trimmed(colon == std::string_view::npos ? words.back() : line.substr(colon + 1)));
  std::replace(value.begin(), value.end(), ',', '.');
  const auto number = parse_number(value);
  if (!number)
    return error(std::string("expected a number after '") + (is_time ? "Frame Time:" : "Frames:") +
                 "', found " + in_quotes(value));
  if (is_time) {
    frame_time_s_ = *number;
    frame_time_line_ = lines_.number();
    return true;
  }
  if (!(std::abs(*number) < 1e15)) return error("expected a number of frames, found " + in_quotes(value));
  declared_frames_ = static_cast<long long>(*number);
  frames_line_ = lines_.number();
  // Never trust the count for memory: a frame takes at least two characters per value.
  const std::size_t possible = lines_.rest().size() / (2 * hierarchy_.values_per_row) + 1;
  const std::size_t declared = *number > 0 ? static_cast<std::size_t>(*number) : 0;
  for (NamedMotion& motion : motions_) motion.frames.reserve(std::min(declared, possible));
  return true;
}

Error MotionParser::bad_value(std::size_t index, const std::string& found) const {
  constexpr std::array<const char*, 6> channel_names = {"Xposition", "Yposition", "Zposition",
                                                        "Xrotation", "Yrotation", "Zrotation"};
  std::string place = "the end of the row";
  for (const BvhNode& node : hierarchy_.nodes) {
    if (index < node.channels.size()) {
      place = node.name + " " + channel_names[static_cast<std::size_t>(node.channels[index])];
      break;
    }
    index -= node.channels.size();
  }
  return error("frame " + std::to_string(frames_) + " (counted from 0) has " + found +
               " where a number was expected (" + place + "); correct it or leave the frame out");
}

Status MotionParser::read_row(std::string_view line) {
  row_.clear();
  RowScanner scanner(line, lines_.number(), glued_, commas_);
  while (scanner.more()) {
    const auto number = scanner.next();
    if (!number) return bad_value(row_.size(), in_quotes(scanner.word()));
    if (!std::isfinite(*number))
      return bad_value(row_.size(), std::isnan(*number) ? "'nan'" : "an infinite value");
    row_.push_back(*number);
  }
  if (row_.size() < hierarchy_.values_per_row && frames_ > 0 && trimmed(lines_.rest()).empty()) {
    warn("truncated", lines_.number(),
         "the file ends inside a frame; the " + std::to_string(frames_) + " whole frames were kept");
    return Done{};
  }
  if (row_.size() != hierarchy_.values_per_row)
    return error("expected " + std::to_string(hierarchy_.values_per_row) +
                 " numbers (one per channel), found " + std::to_string(row_.size()));
  append_frame();
  return Done{};
}

void MotionParser::append_frame() {
  place_nodes(hierarchy_.nodes, row_, world_, places_);
  for (std::size_t m = 0; m < motions_.size(); ++m)
    motions_[m].frames.emplace_back(
        places_.middleRows(first_nodes_[m], static_cast<Eigen::Index>(motions_[m].points.size())));
  ++frames_;
}

/// With the digits that tell it from a whole number: "30.0003".
std::string fps_text(double fps) {
  return fmt::format("{:.8g}", fps);
}

/// Files round the frame time: 0.033333 s is meant to be 30 fps. NTSC rates (29.97, 59.94) are 0.1 % off and
/// stay.
std::optional<double> MotionParser::settle_rate() {
  if (!frame_time_s_) {
    warn("frame-time", 0, "the file has no 'Frame Time:'");
    return std::nullopt;
  }
  if (!(*frame_time_s_ > 0) || !std::isfinite(1.0 / *frame_time_s_)) {
    warn("frame-time", frame_time_line_, "'Frame Time: " + exact_text(*frame_time_s_) + "' is no frame rate");
    return std::nullopt;
  }
  const double fps = 1.0 / *frame_time_s_;
  const double whole = std::round(fps);
  if (whole < 1 || std::abs(fps - whole) > 3e-4 * whole) return fps;
  if (std::abs(fps - whole) > 1e-6)
    warn("fps-rounded", frame_time_line_, fps_text(fps) + " fps was rounded to " + exact_text(whole));
  return whole;
}

void MotionParser::report_oddities() {
  if (declared_frames_ && *declared_frames_ != static_cast<long long>(frames_))
    warn("frame-count", frames_line_,
         "the file announces " + std::to_string(*declared_frames_) + " frames and has " +
             std::to_string(frames_) + "; those were read");
  if (!declared_frames_)
    warn("frame-count", 0,
         "the file does not say how many frames it has; " + std::to_string(frames_) + " were read");
  if (glued_.count > 0)
    warn("glued-numbers", glued_.first_line,
         std::to_string(glued_.count) +
             " time(s) two numbers stand without a blank between; they were taken apart at the sign");
  if (commas_.count > 0)
    warn("commas", commas_.first_line,
         std::to_string(commas_.count) +
             " comma(s) among the numbers; taken as decimal signs between digits, else as separators");
}

Result<std::vector<NamedMotion>> MotionParser::parse() {
  split_roots();
  std::string_view line;
  while (lines_.next(line)) {
    line = trimmed(line);
    if (line.empty()) continue;
    if (frames_ == 0 && (line.front() == 'F' || line.front() == 'f')) {
      const Result<bool> is_header = read_header(line);
      if (!is_header) return is_header.error();
      if (*is_header) continue;
    }
    if (const Status read = read_row(line); !read) return read.error();
  }
  if (frames_ == 0) return error("there are no frames after MOTION");
  report_oddities();
  const std::optional<double> fps = settle_rate();
  for (NamedMotion& motion : motions_) {
    motion.fps = fps;
    motion.warnings = hierarchy_.warnings;
  }
  return std::move(motions_);
}

}  // namespace

Result<std::vector<NamedMotion>> read_bvh(std::string_view text, std::string_view where) {
  LineReader lines(text);
  Result<BvhHierarchy> hierarchy = parse_bvh_hierarchy(lines, where);
  if (!hierarchy) return hierarchy.error();
  return MotionParser(lines, where, std::move(*hierarchy)).parse();
}

}  // namespace abrazo
