#include "core/annotation/suggestion_reason.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/annotation/segment_features.hpp"
#include "core/base/positions.hpp"
#include "core/motion/body/joint_set.hpp"

namespace abrazo {

namespace {

constexpr double worth_saying = 0.35;  ///< share of a stretch that a hold lasts
constexpr double turned = 0.35;        ///< [turns]
constexpr double exchanged = 0.3;      ///< [turns] of the line between the two
constexpr double apart_m = 1.25;       ///< between the roots
constexpr double strike_m_per_s = 4;   ///< a hand or foot as fast as this is remarked on
constexpr double lead_worth_saying = 0.02;

/// Words joined by "; ".
class Remarks {
 public:
  void add(const std::string& words) { text_ += (text_.empty() ? "" : "; ") + words; }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

/// Share of frames in which something holds.
template <typename Holds>
double share_of(int begin, int end, const Holds& holds) {
  int frames = 0;
  for (int f = begin; f < end; ++f) frames += holds(static_cast<std::size_t>(f)) ? 1 : 0;
  return static_cast<double>(frames) / std::max(1, end - begin);
}

double back_share(const std::vector<Pose>& mine, const std::vector<Pose>& yours, int hand, int begin,
                  int end) {
  return share_of(begin, end, [&](std::size_t f) {
    return back_distance(joint_at(mine[f], hand), yours[f]) < hand_on_back_m;
  });
}

void say_holds(Remarks& remarks, const CoupleMotion& motion, int begin, int end) {
  const std::array<const char*, 4> words = {"left hand of A holds right hand of B",
                                            "right hand of A holds left hand of B",
                                            "left hands hold one another", "right hands hold one another"};
  for (std::size_t pair = 0; pair < hand_pairs.size(); ++pair) {
    const double share = share_of(begin, end, [&](std::size_t f) {
      return hand_distance(motion.a[f], motion.b[f], hand_pairs[pair]) < held_hands_m;
    });
    if (share >= worth_saying) remarks.add(fmt::format("{} {:.0f} % of it", words[pair], 100 * share));
  }
}

void say_backs(Remarks& remarks, const CoupleMotion& motion, int begin, int end) {
  for (const bool is_b : {false, true})
    for (const bool is_left : {false, true}) {
      const auto &mine = is_b ? motion.b : motion.a, &yours = is_b ? motion.a : motion.b;
      const double share =
          back_share(mine, yours, is_left ? joints::left_hand : joints::right_hand, begin, end);
      if (share >= worth_saying)
        remarks.add(fmt::format("{} hand of {} on {}'s back {:.0f} % of it", is_left ? "left" : "right",
                                is_b ? "B" : "A", is_b ? "A" : "B", 100 * share));
    }
}

void say_turns(Remarks& remarks, const CoupleGeometry& geometry, int begin, int end) {
  const int last = end - 1;
  const std::array<double, 2> net = {geometry.n_a(last) - geometry.n_a(begin),
                                     geometry.n_b(last) - geometry.n_b(begin)};
  for (std::size_t who = 0; who < 2; ++who)
    if (std::abs(net[who]) >= turned)
      remarks.add(fmt::format("{} turns {:.1f} {}", who == 0 ? "A" : "B", std::abs(net[who]),
                              net[who] > 0 ? "left" : "right"));
  const double places =
      geometry.orb[static_cast<std::size_t>(last)] - geometry.orb[static_cast<std::size_t>(begin)];
  if (std::abs(places) >= exchanged)
    remarks.add(fmt::format("places exchanged {} {:.1f}", places > 0 ? "left" : "right", std::abs(places)));
}

struct Strike {
  double speed = 0;  ///< [m/s]
  const char* words = "";
};
/// The fastest of a performer's hands and feet.
Strike fastest(const std::vector<Pose>& poses, double fps, int begin, int end) {
  const std::array<std::pair<int, const char*>, 4> ends = {{{joints::left_hand, "left hand"},
                                                            {joints::right_hand, "right hand"},
                                                            {joints::left_ankle, "left foot"},
                                                            {joints::right_ankle, "right foot"}}};
  Strike best;
  for (const auto& [index, words] : ends)
    for (int f = begin + 1; f < end; ++f) {
      const auto i = static_cast<std::size_t>(f);
      const double speed = (joint_at(poses[i], index) - joint_at(poses[i - 1], index)).norm() * fps;
      if (speed > best.speed) best = {speed, words};
    }
  return best;
}

}  // namespace

std::string seen_geometry(const CoupleMotion& motion, const CoupleGeometry& geometry, int begin, int end) {
  Remarks remarks;
  say_turns(remarks, geometry, begin, end);
  say_holds(remarks, motion, begin, end);
  say_backs(remarks, motion, begin, end);
  const double apart = share_of(begin, end, [&](std::size_t f) {
    const Vec3 line = joint_at(motion.a[f], joints::Root) - joint_at(motion.b[f], joints::Root);
    return std::hypot(line.x(), line.z()) > apart_m;
  });
  if (apart >= worth_saying)
    remarks.add(fmt::format("farther than 1.25 m apart {:.0f} % of it", 100 * apart));
  for (const bool is_b : {false, true}) {
    const Strike strike = fastest(is_b ? motion.b : motion.a, motion.fps, begin, end);
    if (strike.speed >= strike_m_per_s)
      remarks.add(fmt::format("{} of {} reaches {:.1f} m/s", strike.words, is_b ? "B" : "A", strike.speed));
  }
  return std::move(remarks).text();
}

std::string neighbour_words(const ProposedMove& move, const LabelledMoves& labelled) {
  if (move.neighbours.empty()) return "no labelled move is like it";
  std::vector<int> label_of;
  for (const LabelledTake& take : labelled.takes)
    for (const LabelledMove& other : take.moves) label_of.push_back(other.label);
  const auto same = std::count_if(move.neighbours.begin(), move.neighbours.end(), [&](const auto& neighbour) {
    return label_of[static_cast<std::size_t>(neighbour.origin)] == move.label;
  });
  return fmt::format("{} of {} nearest labelled moves: {}", same, move.neighbours.size(),
                     labelled.labels[static_cast<std::size_t>(move.label)]);
}

std::string role_words(const CoupleMotion& motion, const std::array<MotionChannels, 2>& channels, int begin,
                       int end, int active) {
  Remarks remarks;
  const MotionChannels& order = channels[static_cast<std::size_t>(active)];
  const char *me = active == 0 ? "A" : "B", *other = active == 0 ? "B" : "A";
  const auto lead =
      static_cast<double>(order.values.middleRows(begin, end - begin).rightCols(lead_channel_count).mean());
  if (lead >= lead_worth_saying) remarks.add(fmt::format("{} moves first more often than {}", me, other));
  if (lead <= -lead_worth_saying)
    remarks.add(fmt::format("although {} moves first more often than {}", other, me));
  const auto &mine = active == 0 ? motion.a : motion.b, &yours = active == 0 ? motion.b : motion.a;
  for (const bool is_left : {false, true}) {
    const double share =
        back_share(mine, yours, is_left ? joints::left_hand : joints::right_hand, begin, end);
    if (share >= worth_saying / 2)
      remarks.add(fmt::format("{} hand of {} on {}'s back {:.0f} % of it", is_left ? "left" : "right", me,
                              other, 100 * share));
  }
  const Strike my_strike = fastest(mine, motion.fps, begin, end),
               yours_strike = fastest(yours, motion.fps, begin, end);
  if (my_strike.speed >= strike_m_per_s && my_strike.speed > yours_strike.speed)
    remarks.add(fmt::format("{} of {} is the fastest, {:.1f} m/s", my_strike.words, me, my_strike.speed));
  remarks.add(fmt::format("{} moves like the active performers of the labelled takes", me));
  return std::move(remarks).text();
}

}  // namespace abrazo
