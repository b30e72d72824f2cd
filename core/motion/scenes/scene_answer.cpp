#include "core/motion/scenes/scene_answer.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <set>
#include <type_traits>
#include <utility>

#include "core/base/printable.hpp"

namespace abrazo {

namespace {

constexpr std::string_view answer_begins = "abrazo scene 1\n", answer_ends = "\nwhole";
constexpr std::size_t longest_message = 4000;  ///< [bytes]
enum class AnswerKind : std::uint8_t { Motions, Error };

class AnswerWriter {
 public:
  template <typename Number>
  void number(Number value) {
    static_assert(std::is_trivially_copyable_v<Number>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void count(std::size_t value) { number(static_cast<std::uint64_t>(value)); }
  void raw(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  void text(std::string_view value) {
    count(value.size());
    bytes_.append(value);
  }
  void texts(const std::vector<std::string>& values) {
    count(values.size());
    for (const std::string& value : values) text(value);
  }
  template <typename Number>
  void maybe(const std::optional<Number>& value) {
    number(static_cast<std::uint8_t>(value.has_value()));
    number(value.value_or(Number{}));
  }
  void reserve(std::size_t more) { bytes_.reserve(bytes_.size() + more); }
  std::string take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Each part is there, or nothing is any more.
class AnswerReader {
 public:
  explicit AnswerReader(std::string_view bytes) : rest_(bytes) {}
  bool good() const { return good_; }
  bool at_end() const { return good_ && rest_.empty(); }
  void fail() { good_ = false; }

  std::string_view raw(std::size_t size) {
    if (!good_ || size > rest_.size()) {
      good_ = false;
      return {};
    }
    const std::string_view part = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return part;
  }
  template <typename Number>
  Number number() {
    static_assert(std::is_trivially_copyable_v<Number>);
    Number value{};
    if (const std::string_view part = raw(sizeof value); good_)
      std::memcpy(&value, part.data(), sizeof value);
    return value;
  }
  /// Of things that take at least `least_bytes` each: no more than there can be.
  std::size_t count(std::size_t least_bytes) {
    const auto value = number<std::uint64_t>();
    if (good_ && value > rest_.size() / least_bytes) good_ = false;
    return good_ ? static_cast<std::size_t>(value) : 0;
  }
  std::string text() { return std::string(raw(count(1))); }
  std::vector<std::string> texts() {
    std::vector<std::string> values(count(sizeof(std::uint64_t)));
    for (std::string& value : values) value = text();
    return values;
  }
  bool flag() {
    const auto value = number<std::uint8_t>();
    if (value > 1) good_ = false;
    return value == 1;
  }
  template <typename Number>
  std::optional<Number> maybe() {
    const bool is_there = flag();
    const auto value = number<Number>();
    return good_ && is_there ? std::optional(value) : std::nullopt;
  }

 private:
  std::string_view rest_;
  bool good_ = true;
};

void write_motion(const NamedMotion& motion, AnswerWriter& out) {
  out.text(motion.name);
  out.texts(motion.points);
  for (const int parent : motion.parents) out.number(static_cast<std::int32_t>(parent));
  out.maybe(motion.fps);
  out.maybe(motion.metres_per_unit);
  out.maybe(motion.up_axis ? std::optional<std::int32_t>(static_cast<std::int32_t>(*motion.up_axis))
                           : std::nullopt);
  out.texts(motion.animations);
  out.count(motion.warnings.size());
  for (const ImportWarning& warning : motion.warnings) {
    out.text(warning.kind);
    out.number(static_cast<std::int32_t>(warning.line));
    out.text(warning.detail);
  }
  out.count(motion.frames.size());
  const std::size_t frame_bytes = motion.points.size() * 3 * sizeof(double);
  out.reserve(motion.frames.size() * frame_bytes + answer_ends.size());
  for (const Positions& frame : motion.frames) out.raw(frame.data(), frame_bytes);
}

NamedMotion read_answered_motion(AnswerReader& in) {
  NamedMotion motion;
  motion.name = in.text();
  motion.points = in.texts();
  if (std::set<std::string_view>(motion.points.begin(), motion.points.end()).size() != motion.points.size())
    in.fail();
  for (std::size_t p = 0; p < motion.points.size() && in.good(); ++p) {
    motion.parents.push_back(in.number<std::int32_t>());
    if (motion.parents.back() < -1 || motion.parents.back() >= static_cast<int>(p)) in.fail();
  }
  motion.fps = in.maybe<double>();
  motion.metres_per_unit = in.maybe<double>();
  if (const auto axis = in.maybe<std::int32_t>()) {
    if (*axis < 0 || *axis >= static_cast<std::int32_t>(every_up_axis.size())) in.fail();
    if (in.good()) motion.up_axis = every_up_axis[static_cast<std::size_t>(*axis)];
  }
  motion.animations = in.texts();
  motion.warnings.resize(in.count(2 * sizeof(std::uint64_t) + sizeof(std::int32_t)));
  for (ImportWarning& warning : motion.warnings) {
    warning.kind = in.text();
    warning.line = in.number<std::int32_t>();
    warning.detail = in.text();
  }
  const std::size_t frame_bytes = motion.points.size() * 3 * sizeof(double);
  const std::size_t frames = in.count(std::max<std::size_t>(1, frame_bytes));
  motion.frames.reserve(frames);
  for (std::size_t f = 0; f < frames && in.good(); ++f) {
    Positions& frame = motion.frames.emplace_back(static_cast<Eigen::Index>(motion.points.size()), 3);
    if (const std::string_view values = in.raw(frame_bytes); in.good() && frame_bytes > 0)
      std::memcpy(frame.data(), values.data(), frame_bytes);
  }
  return motion;
}

}  // namespace

std::string scene_answer(const Result<std::vector<NamedMotion>>& motions) {
  AnswerWriter out;
  out.raw(answer_begins.data(), answer_begins.size());
  out.number(motions ? AnswerKind::Motions : AnswerKind::Error);
  if (motions) {
    out.count(motions->size());
    for (const NamedMotion& motion : *motions) write_motion(motion, out);
  } else {
    out.text(motions.error().message.substr(0, longest_message));
  }
  out.raw(answer_ends.data(), answer_ends.size());
  return std::move(out).take();
}

SceneAnswer parse_scene_answer(std::string_view bytes, const std::string& file) {
  AnswerReader in(bytes);
  if (in.raw(answer_begins.size()) != answer_begins) return {};
  SceneAnswer answer;
  const auto kind = in.number<AnswerKind>();
  if (kind == AnswerKind::Error) {
    const std::string message = in.text();
    if (message.empty() || message.size() > longest_message) return {};
    answer.motions = Error{printable_line(message), file};
  } else if (kind == AnswerKind::Motions) {
    std::vector<NamedMotion> motions(in.count(4 * sizeof(std::uint64_t)));
    for (NamedMotion& motion : motions)
      if (in.good()) motion = read_answered_motion(in);
    if (motions.empty()) return {};
    answer.motions = std::move(motions);
  } else {
    return {};
  }
  if (in.raw(answer_ends.size()) != answer_ends || !in.at_end()) return {};
  answer.is_whole = true;
  return answer;
}

}  // namespace abrazo
