#include "core/motion/joints/marker_words.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/motion/body/joint_set.hpp"
#include "core/motion/joints/marker_set.hpp"

namespace abrazo {

namespace {

using enum MarkerPlace;

enum class MarkedPart {
  PelvisFront,
  PelvisBack,
  Shoulder,
  Elbow,
  Wrist,
  Hand,
  Thigh,
  Knee,
  Ankle,
  Heel,
  Toe,
  Neck,
  Head
};
enum class On { Plain, Front, Back, Inner, Outer, Top, Low, Count };

template <typename Value>
struct Word {
  std::string_view text;
  Value value;
};

/// Beginnings of a name behind its side; longer ones first where one begins another.
constexpr std::array<Word<MarkedPart>, 30> segments = {
    {{"asi", MarkedPart::PelvisFront}, {"ias", MarkedPart::PelvisFront}, {"psi", MarkedPart::PelvisBack},
     {"ips", MarkedPart::PelvisBack},  {"shld", MarkedPart::Shoulder},   {"shoulder", MarkedPart::Shoulder},
     {"sho", MarkedPart::Shoulder},    {"acr", MarkedPart::Shoulder},    {"elbow", MarkedPart::Elbow},
     {"elb", MarkedPart::Elbow},       {"wrist", MarkedPart::Wrist},     {"wri", MarkedPart::Wrist},
     {"wr", MarkedPart::Wrist},        {"hand", MarkedPart::Hand},       {"fin", MarkedPart::Hand},
     {"thigh", MarkedPart::Thigh},     {"topleg", MarkedPart::Thigh},    {"knee", MarkedPart::Knee},
     {"kne", MarkedPart::Knee},        {"kn", MarkedPart::Knee},         {"ankle", MarkedPart::Ankle},
     {"ank", MarkedPart::Ankle},       {"heel", MarkedPart::Heel},       {"hee", MarkedPart::Heel},
     {"calc", MarkedPart::Heel},       {"toe", MarkedPart::Toe},         {"neck", MarkedPart::Neck},
     {"head", MarkedPart::Head},       {"hd", MarkedPart::Head},         {"shl", MarkedPart::Shoulder}}};
/// Ends of a name.
constexpr std::array<Word<On>, 19> places_on = {{{"front", On::Front},
                                                 {"fr", On::Front},
                                                 {"ant", On::Front},
                                                 {"back", On::Back},
                                                 {"bk", On::Back},
                                                 {"post", On::Back},
                                                 {"inner", On::Inner},
                                                 {"med", On::Inner},
                                                 {"ins", On::Inner},
                                                 {"int", On::Inner},
                                                 {"is", On::Inner},
                                                 {"outer", On::Outer},
                                                 {"lat", On::Outer},
                                                 {"ext", On::Outer},
                                                 {"out", On::Outer},
                                                 {"top", On::Top},
                                                 {"up", On::Top},
                                                 {"low", On::Low},
                                                 {"bot", On::Low}}};

struct NameOfMarker {
  int side = -1;  ///< 0 left, 1 right
  MarkedPart segment = MarkedPart::Neck;
  On on = On::Plain;
};

std::optional<MarkedPart> segment_of(std::string_view word, std::string_view& rest) {
  for (const auto& [text, segment] : segments)
    if (word.starts_with(text)) {
      rest = word.substr(text.size());
      return segment;
    }
  return std::nullopt;
}

On place_at_end(std::string_view rest) {
  for (const auto& [text, on] : places_on)
    if (rest.ends_with(text)) return on;
  return On::Plain;
}

/// "R.Knee.Lat", "rkneelat", "fhead".
std::optional<NameOfMarker> read_name(std::string name) {
  if (const auto colon = name.rfind(':'); colon != std::string::npos) name.erase(0, colon + 1);
  std::string plain;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      plain += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::string_view word = plain, rest;
  NameOfMarker result;
  for (const auto& [text, side] :
       {std::pair<std::string_view, int>("left", 0), {"right", 1}, {"l", 0}, {"r", 1}})
    if (result.side < 0 && word.starts_with(text) && segment_of(word.substr(text.size()), rest))
      result.side = side, word.remove_prefix(text.size());
  if (result.side < 0 && (word.starts_with('f') || word.starts_with('b')) &&
      segment_of(word.substr(1), rest)) {
    result.on = word.front() == 'f' ? On::Front : On::Back;
    word.remove_prefix(1);
  }
  const auto segment = segment_of(word, rest);
  if (!segment) return std::nullopt;
  result.segment = *segment;
  if (result.on == On::Plain) result.on = place_at_end(rest);
  return result;
}

std::string toe_name(std::size_t side) {
  return side == 0 ? "left toe, inferred" : "right toe, inferred";
}

/// Markers of one segment and side, by their place on it.
using Around = std::array<std::string, static_cast<std::size_t>(On::Count)>;

const std::string& at(const Around& around, On on) {
  return around[static_cast<std::size_t>(on)];
}

/// Two opposite markers; the first alone where there is no such pair.
std::pair<std::string, std::string> opposite(const Around& around) {
  for (const auto& [one, other] :
       {std::pair(On::Outer, On::Inner), {On::Front, On::Back}, {On::Top, On::Low}})
    if (!at(around, one).empty() && !at(around, other).empty()) return {at(around, one), at(around, other)};
  for (const On on : {On::Plain, On::Outer, On::Top})
    if (!at(around, on).empty()) return {at(around, on), ""};
  return {};
}

class Reader {
 public:
  explicit Reader(const std::vector<std::string>& points) {
    for (const std::string& point : points)
      if (const auto name = read_name(point)) {
        const auto side = static_cast<std::size_t>(std::max(0, name->side));
        auto& place =
            around_[static_cast<std::size_t>(name->segment)][side][static_cast<std::size_t>(name->on)];
        if (place.empty()) place = point;
        if (name->side < 0) unsided_.push_back(point);
      }
  }

  MarkerModel model() const {
    MarkerModel model;
    model.name = "by the words of their names";
    const auto set = [&](MarkerPlace place, std::size_t side, const std::string& point) {
      if (!point.empty()) model.names[static_cast<std::size_t>(place)][side] = {point};
    };
    for (const std::size_t side : {0U, 1U}) {
      set(PelvisFront, side, any(MarkedPart::PelvisFront, side));
      set(PelvisBack, side, any(MarkedPart::PelvisBack, side));
      set(Shoulder, side, any(MarkedPart::Shoulder, side));
      set(Thigh, side, any(MarkedPart::Thigh, side));
      set(Heel, side, any(MarkedPart::Heel, side));
      set(Hand, side, any(MarkedPart::Hand, side));
      for (const auto& [segment, outer, inner] : {std::tuple(MarkedPart::Elbow, Elbow, ElbowInner),
                                                  {MarkedPart::Wrist, WristThumb, WristLittle},
                                                  {MarkedPart::Knee, Knee, KneeInner},
                                                  {MarkedPart::Ankle, Ankle, AnkleInner}}) {
        const auto [one, other] = opposite(of(segment, side));
        set(outer, side, one), set(inner, side, other);
      }
      std::string toe = any(MarkedPart::Toe, side);
      const Around& ankle = of(MarkedPart::Ankle, side);
      // From its back to its front the ankle shows where the foot points.
      if (toe.empty() && !at(ankle, On::Back).empty() && opposite(ankle).second == at(ankle, On::Back))
        toe = toe_name(side);
      set(Toe, side, toe);
    }
    set(Clavicle, 0, unsided(MarkedPart::Neck, On::Front));
    set(Neck, 0, unsided(MarkedPart::Neck, On::Back));
    set(HeadFront, 0, unsided(MarkedPart::Head, On::Front));
    for (const std::size_t side : {0U, 1U}) set(Ear, side, sided(MarkedPart::Head, side));
    return model;
  }

 private:
  const Around& of(MarkedPart segment, std::size_t side) const {
    return around_[static_cast<std::size_t>(segment)][side];
  }
  bool is_unsided(const std::string& point) const {
    return std::ranges::find(unsided_, point) != unsided_.end();
  }
  std::string any(MarkedPart segment, std::size_t side) const {
    for (const std::string& point : of(segment, side))
      if (!point.empty() && !is_unsided(point)) return point;
    return {};
  }
  std::string sided(MarkedPart segment, std::size_t side) const {
    const std::string& point = at(of(segment, side), On::Plain);
    return is_unsided(point) ? std::string() : point;
  }
  std::string unsided(MarkedPart segment, On on) const {
    const std::string& point = at(of(segment, 0), on);
    return is_unsided(point) ? point : std::string();
  }

  std::array<std::array<Around, 2>, 13> around_;
  std::vector<std::string> unsided_;
};

int index_of(const NamedMotion& motion, const std::string& point) {
  const auto found = std::ranges::find(motion.points, point);
  return found == motion.points.end() ? -1 : static_cast<int>(found - motion.points.begin());
}

}  // namespace

std::optional<MarkerModel> marker_model_by_words(const std::vector<std::string>& points) {
  std::vector<std::string> all = points;
  MarkerModel model = Reader(points).model();
  all.insert(all.end(), {toe_name(0), toe_name(1)});
  if (!missing_markers(model, all).empty()) return std::nullopt;
  return model;
}

std::vector<int> add_inferred_toes(const MarkerModel& model, NamedMotion& markers) {
  constexpr double ahead = 1.3;   ///< of the ankle's depth: the ball of the foot
  constexpr double below = 0.25;  ///< of the shin
  std::vector<int> inferred;
  for (const std::size_t side : {0U, 1U}) {
    const auto name_at = [&](MarkerPlace place) {
      const auto& names = model.names[static_cast<std::size_t>(place)][side];
      return names.empty() ? std::string() : names.front();
    };
    if (name_at(Toe) != toe_name(side)) continue;
    const int front = index_of(markers, name_at(Ankle)), back = index_of(markers, name_at(AnkleInner)),
              knee = index_of(markers, name_at(Knee));
    if (front < 0 || back < 0 || knee < 0) continue;
    int inner_knee = index_of(markers, name_at(KneeInner));
    if (inner_knee < 0) inner_knee = knee;
    for (Positions& frame : markers.frames) {
      const Eigen::RowVector3d ankle = (frame.row(front) + frame.row(back)) / 2;
      const Eigen::RowVector3d above = (frame.row(knee) + frame.row(inner_knee)) / 2;
      const Eigen::RowVector3d toe =
          ankle + ahead * (frame.row(front) - frame.row(back)) + below * (ankle - above);
      frame.conservativeResize(frame.rows() + 1, Eigen::NoChange);
      frame.row(frame.rows() - 1) = toe;
    }
    markers.points.push_back(toe_name(side));
    markers.parents.push_back(-1);
    inferred.insert(inferred.end(), {side == 0 ? joints::left_toe_base : joints::right_toe_base});
  }
  return inferred;
}

}  // namespace abrazo
