#include "core/motion/joints/marker_gaps.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

#include "core/motion/joints/performers.hpp"

namespace abrazo {

namespace {

constexpr double curve_s = 0.2, longest_curve_s = 0.5, held_s = 0.1;
constexpr double usual_rate_fps = 100;
constexpr double rigid_share =
    0.04;  ///< by which the distance of two markers of one segment changes (deviation)
constexpr std::size_t most_samples = 200;  ///< frames that are looked at for it

bool seen(const NamedMotion& motion, std::size_t frame, int point) {
  return std::isfinite(motion.frames[frame](point, 0));
}
Vec3 at(const NamedMotion& motion, std::size_t frame, int point) {
  return motion.frames[frame].row(point).transpose();
}

struct Gap {
  int point = 0;
  std::size_t begin = 0, end = 0;  ///< frames, end exclusive
  std::size_t length() const { return end - begin; }
};

std::vector<Gap> gaps_in(const NamedMotion& motion, int point) {
  std::vector<Gap> gaps;
  for (std::size_t f = 0; f < motion.frames.size(); ++f) {
    if (seen(motion, f, point)) continue;
    if (!gaps.empty() && gaps.back().end == f)
      ++gaps.back().end;
    else
      gaps.push_back({point, f, f + 1});
  }
  return gaps;
}

/// Axes on three markers; nothing when they lie on a line.
std::optional<Eigen::Isometry3d> frame_on(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 x = b - a, z = x.cross(c - a);
  if (!(z.norm() > 0.15 * x.norm() * (c - a).norm())) return std::nullopt;
  Eigen::Isometry3d frame = Eigen::Isometry3d::Identity();
  frame.linear().col(0) = x.normalized();
  frame.linear().col(2) = z.normalized();
  frame.linear().col(1) = frame.linear().col(2).cross(frame.linear().col(0));
  frame.translation() = (a + b + c) / 3;
  return frame;
}

class GapFiller {
 public:
  explicit GapFiller(NamedMotion& motion) : motion_(motion), original_(motion) {}
  void fill();

 private:
  struct Tally {
    std::size_t gaps = 0, frames = 0, longest = 0;
    std::string longest_place;
    std::set<std::string> markers;
  };
  void remove_unseen();
  void fill(const Gap& gap);
  bool carry(const Gap& gap);
  void curve(const Gap& gap);
  bool hold(const Gap& gap);
  std::vector<int> companions(int point) const;
  std::optional<double> rigidity(int a, int b) const;
  void note(Tally& tally, const Gap& gap);
  void report(const Tally& tally, const std::string& kind, const std::string& how);

  NamedMotion& motion_;
  NamedMotion original_;  ///< so that filled values are not used to fill others
  Tally curved_, carried_, held_, left_;
};

void GapFiller::remove_unseen() {
  std::vector<int> kept;
  std::vector<std::string> unseen;
  std::vector<int> place(motion_.points.size(), -1);
  for (int p = 0; p < static_cast<int>(motion_.points.size()); ++p) {
    bool any = false;
    for (std::size_t f = 0; f < motion_.frames.size() && !any; ++f) any = seen(motion_, f, p);
    if (any) {
      place[static_cast<std::size_t>(p)] = static_cast<int>(kept.size());
      kept.push_back(p);
    } else {
      unseen.push_back(motion_.points[static_cast<std::size_t>(p)]);
    }
  }
  if (unseen.empty()) return;
  NamedMotion smaller = motion_;
  smaller.points.clear(), smaller.parents.clear();
  for (const int p : kept) {
    smaller.points.push_back(motion_.points[static_cast<std::size_t>(p)]);
    const int parent = motion_.parents[static_cast<std::size_t>(p)];
    smaller.parents.push_back(parent < 0 ? -1 : place[static_cast<std::size_t>(parent)]);
  }
  for (Positions& frame : smaller.frames) frame = frame(kept, Eigen::seqN(0, Eigen::fix<3>)).eval();
  smaller.warnings.push_back({"never-seen", 0, some_of(unseen) + ": never seen, left out"});
  motion_ = std::move(smaller);
}

/// Deviation of two markers' distance over its mean.
std::optional<double> GapFiller::rigidity(int a, int b) const {
  double sum = 0, squares = 0, count = 0;
  const std::size_t step = std::max<std::size_t>(1, original_.frames.size() / most_samples);
  for (std::size_t f = 0; f < original_.frames.size(); f += step) {
    if (!seen(original_, f, a) || !seen(original_, f, b)) continue;
    const double distance = (at(original_, f, a) - at(original_, f, b)).norm();
    sum += distance, squares += distance * distance, ++count;
  }
  if (count < 5 || !(sum > 0)) return std::nullopt;
  const double mean = sum / count;
  return std::sqrt(std::max(0.0, squares / count - mean * mean)) / mean;
}

/// Markers that keep their distance to this one, the steadiest first; at most 6.
std::vector<int> GapFiller::companions(int point) const {
  std::vector<std::pair<double, int>> found;
  for (int other = 0; other < static_cast<int>(original_.points.size()); ++other) {
    if (other == point) continue;
    const auto change = rigidity(point, other);
    if (change && *change < rigid_share) found.emplace_back(*change, other);
  }
  std::sort(found.begin(), found.end());
  std::vector<int> best;
  for (std::size_t i = 0; i < found.size() && i < 6; ++i) best.push_back(found[i].second);
  return best;
}

/// Where the marker was on its segment before and after the gap, moved on with the segment.
bool GapFiller::carry(const Gap& gap) {
  const std::vector<int> near = companions(gap.point);
  const bool before = gap.begin > 0, after = gap.end < original_.frames.size();
  const std::size_t first = before ? gap.begin - 1 : gap.begin, last = after ? gap.end : gap.end - 1;
  for (std::size_t i = 0; i < near.size(); ++i)
    for (std::size_t j = i + 1; j < near.size(); ++j)
      for (std::size_t k = j + 1; k < near.size(); ++k) {
        const std::array<int, 3> three = {near[i], near[j], near[k]};
        std::vector<Eigen::Isometry3d> frames;
        for (std::size_t f = first; f <= last; ++f) {
          if (!seen(original_, f, three[0]) || !seen(original_, f, three[1]) || !seen(original_, f, three[2]))
            break;
          const auto frame =
              frame_on(at(original_, f, three[0]), at(original_, f, three[1]), at(original_, f, three[2]));
          if (!frame) break;
          frames.push_back(*frame);
        }
        if (frames.size() != last - first + 1) continue;
        Vec3 from = Vec3::Zero(), to = Vec3::Zero();
        if (before) from = to = frames.front().inverse() * at(original_, first, gap.point);
        if (after) to = frames.back().inverse() * at(original_, last, gap.point);
        if (!before) from = to;
        for (std::size_t f = gap.begin; f < gap.end; ++f) {
          const double t =
              static_cast<double>(f - first) / static_cast<double>(std::max<std::size_t>(1, last - first));
          motion_.frames[f].row(gap.point) = (frames[f - first] * (from + t * (to - from))).transpose();
        }
        return true;
      }
  return false;
}

/// Cubic Hermite between the sightings at both sides.
void GapFiller::curve(const Gap& gap) {
  const std::size_t a = gap.begin - 1, b = gap.end;
  const Vec3 from = at(original_, a, gap.point), to = at(original_, b, gap.point);
  const double length = static_cast<double>(b - a);
  const auto speed = [&](std::size_t one, std::size_t other, bool known) -> Vec3 {
    return known && seen(original_, one, gap.point) && seen(original_, other, gap.point)
               ? Vec3(at(original_, other, gap.point) - at(original_, one, gap.point))
               : Vec3((to - from) / length);
  };
  const Vec3 before = speed(a - 1, a, a > 0) * length;
  const Vec3 after = speed(b, b + 1, b + 1 < original_.frames.size()) * length;
  for (std::size_t f = gap.begin; f < gap.end; ++f) {
    const double t = static_cast<double>(f - a) / length, u = 1 - t;
    const Vec3 place =
        u * u * (1 + 2 * t) * from + t * t * (3 - 2 * t) * to + u * u * t * before - t * t * u * after;
    motion_.frames[f].row(gap.point) = place.transpose();
  }
}

bool GapFiller::hold(const Gap& gap) {
  const bool before = gap.begin > 0;
  const Vec3 place = at(original_, before ? gap.begin - 1 : gap.end, gap.point);
  for (std::size_t f = gap.begin; f < gap.end; ++f) motion_.frames[f].row(gap.point) = place.transpose();
  return true;
}

void GapFiller::note(Tally& tally, const Gap& gap) {
  const std::string& marker = motion_.points[static_cast<std::size_t>(gap.point)];
  ++tally.gaps;
  tally.frames += gap.length();
  tally.markers.insert(marker);
  if (gap.length() <= tally.longest) return;
  tally.longest = gap.length();
  tally.longest_place = marker + " from frame " + std::to_string(gap.begin);
}

void GapFiller::fill(const Gap& gap) {
  const double length_s = static_cast<double>(gap.length()) / motion_.fps.value_or(usual_rate_fps);
  const bool inside = gap.begin > 0 && gap.end < motion_.frames.size();
  if (inside && length_s <= curve_s) return curve(gap), note(curved_, gap);
  if (carry(gap)) return note(carried_, gap);
  if (inside && length_s <= longest_curve_s) return curve(gap), note(curved_, gap);
  if (!inside && length_s <= held_s && hold(gap)) return note(held_, gap);
  note(left_, gap);
}

void GapFiller::report(const Tally& tally, const std::string& kind, const std::string& how) {
  if (tally.gaps == 0) return;
  const std::vector<std::string> markers(tally.markers.begin(), tally.markers.end());
  motion_.warnings.push_back({kind, 0,
                              std::to_string(tally.gaps) + " gap" + (tally.gaps > 1 ? "s" : "") + " of " +
                                  some_of(markers) + " (" + std::to_string(tally.frames) +
                                  " frames in all, the longest " + std::to_string(tally.longest) + ", " +
                                  tally.longest_place + ") " + how});
}

void GapFiller::fill() {
  remove_unseen();
  original_ = motion_;
  for (int p = 0; p < static_cast<int>(motion_.points.size()); ++p)
    for (const Gap& gap : gaps_in(original_, p)) fill(gap);
  report(curved_, "gaps", "bridged by a curve");
  report(carried_, "gaps-carried", "carried by the markers of the same segment");
  report(held_, "gaps-held", "at the beginning or end: held");
  report(left_, "gaps-left", "too long to fill; what needs them cannot be computed");
}

}  // namespace

void fill_gaps(NamedMotion& motion) {
  const bool whole = std::all_of(motion.frames.begin(), motion.frames.end(),
                                 [](const Positions& frame) { return frame.allFinite(); });
  if (!whole) GapFiller(motion).fill();
}

std::string gaps_of(const NamedMotion& motion, const std::vector<int>& points) {
  std::string text;
  for (const int point : points) {
    const std::vector<Gap> gaps = gaps_in(motion, point);
    if (gaps.empty()) continue;
    const auto longest = std::max_element(gaps.begin(), gaps.end(),
                                          [](const Gap& a, const Gap& b) { return a.length() < b.length(); });
    text += (text.empty() ? "" : "; ") + motion.points[static_cast<std::size_t>(point)] +
            " is missing in frames " + std::to_string(longest->begin) + " to " +
            std::to_string(longest->end - 1);
    if (gaps.size() > 1) text += " and in " + std::to_string(gaps.size() - 1) + " other places";
  }
  return text;
}

}  // namespace abrazo
