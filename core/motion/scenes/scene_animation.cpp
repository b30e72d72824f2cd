#include "core/motion/scenes/scene_animation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include "core/base/text.hpp"
#include "core/motion/joints/performers.hpp"

namespace abrazo {

namespace {

constexpr std::size_t fewest_nodes = 8;              ///< of a skeleton
constexpr double fastest_fps = 1000;                 ///< keys nearer than that are doubled ones
constexpr std::size_t most_positions = 400'000'000;  ///< of all points in all frames: 10 GB

std::size_t index_of(int i) {
  return static_cast<std::size_t>(i);
}

/// The keys around a time and how far it is from the first to the second.
std::tuple<std::size_t, std::size_t, double> around(const std::vector<double>& times, double time) {
  const auto behind = std::upper_bound(times.begin(), times.end(), time);
  const auto second = static_cast<std::size_t>(behind - times.begin());
  if (second == 0) return {0, 0, 0.0};
  if (second == times.size()) return {second - 1, second - 1, 0.0};
  const double length = times[second] - times[second - 1];
  return {second - 1, second, length > 0 ? (time - times[second - 1]) / length : 0.0};
}

Vec3 sample(const Keys<Vec3>& keys, double time) {
  const auto [a, b, t] = around(keys.times_s, time);
  return (1 - t) * keys.values[a] + t * keys.values[b];
}
Eigen::Quaterniond sample(const Keys<Eigen::Quaterniond>& keys, double time) {
  const auto [a, b, t] = around(keys.times_s, time);
  return keys.values[a].slerp(t, keys.values[b]);
}

/// Translation, rotation and scale at rest, for what has no keys.
struct Rest {
  Vec3 translation, scale;
  Eigen::Matrix3d rotation;
};
Rest rest_of(const SceneNode& node) {
  Rest rest;
  rest.translation = node.rest.translation();
  Eigen::Matrix3d scaling;
  node.rest.computeRotationScaling(&rest.rotation, &scaling);
  rest.scale = scaling.diagonal();
  return rest;
}

class Skeletons {
 public:
  Skeletons(const std::vector<SceneNode>& nodes, std::optional<double> rate, const std::string& file)
      : nodes_(nodes), rate_(rate), file_(file) {}
  Result<std::vector<NamedMotion>> read();

 private:
  void find_relevant();
  void find_roots(int node, std::vector<int>& roots) const;
  bool animated(const SceneNode& node) const {
    return !node.translations.times_s.empty() || !node.rotations.times_s.empty();
  }
  std::optional<double> step_of_most() const;
  Status settle_times();
  NamedMotion motion_below(int root) const;
  std::vector<int> points_below(int root) const;
  void sample_frames(std::vector<NamedMotion>& motions, const std::vector<std::vector<int>>& points) const;

  const std::vector<SceneNode>& nodes_;
  std::optional<double> rate_;
  std::string file_;
  std::vector<std::vector<int>> children_;
  std::vector<bool> relevant_;      ///< bone or animated
  std::vector<std::size_t> below_;  ///< relevant nodes in the subtree, itself included
  double begin_s_ = 0, fps_ = 0;
  std::size_t frames_ = 0;
  std::vector<ImportWarning> warnings_;
};

void Skeletons::find_relevant() {
  const std::size_t count = nodes_.size();
  children_.assign(count, {});
  relevant_.assign(count, false);
  below_.assign(count, 0);
  for (std::size_t n = 0; n < count; ++n) {
    if (nodes_[n].parent >= 0) children_[index_of(nodes_[n].parent)].push_back(static_cast<int>(n));
    relevant_[n] = !nodes_[n].is_other && !nodes_[n].is_helper && (nodes_[n].is_bone || animated(nodes_[n]));
  }
  // The animation of helpers is that of the node they belong to.
  for (std::size_t n = 0; n < count; ++n) {
    if (nodes_[n].is_other || nodes_[n].is_helper) continue;
    for (int above = nodes_[n].parent; above >= 0 && nodes_[index_of(above)].is_helper;
         above = nodes_[index_of(above)].parent)
      if (animated(nodes_[index_of(above)])) relevant_[n] = true;
  }
  for (std::size_t n = count; n-- > 0;) {
    below_[n] += relevant_[n] ? 1 : 0;
    if (nodes_[n].parent >= 0) below_[index_of(nodes_[n].parent)] += below_[n];
  }
}

/// Deepest nodes below which a whole skeleton hangs: two armatures under one scene node are two.
void Skeletons::find_roots(int node, std::vector<int>& roots) const {
  std::vector<int> pending{node};
  while (!pending.empty()) {
    const int at = pending.back();
    pending.pop_back();
    if (below_[index_of(at)] < fewest_nodes) continue;
    const auto& children = children_[index_of(at)];
    const auto whole = std::count_if(children.begin(), children.end(),
                                     [&](int child) { return below_[index_of(child)] >= fewest_nodes; });
    std::size_t outside = relevant_[index_of(at)] ? 1 : 0;
    for (const int child : children)
      if (below_[index_of(child)] < fewest_nodes) outside += below_[index_of(child)];
    // A node that moves itself, or has lesser limbs as well, is the root of one skeleton.
    const bool fork = whole >= 1 && outside == 0 && !nodes_[index_of(at)].is_bone;
    if (!fork) {
      roots.push_back(at);
      continue;
    }
    for (auto child = children.rbegin(); child != children.rend(); ++child) pending.push_back(*child);
  }
}

/// The spacing that the keys of most channels have; nothing when most have fewer than two.
std::optional<double> Skeletons::step_of_most() const {
  std::map<long long, std::pair<std::size_t, double>> votes;  // by rate in hundredths of Hz
  for (const SceneNode& node : nodes_)
    for (const std::vector<double>* times : {&node.translations.times_s, &node.rotations.times_s}) {
      if (times->size() < 2) continue;
      std::vector<double> steps;
      for (std::size_t k = 1; k < times->size(); ++k) steps.push_back((*times)[k] - (*times)[k - 1]);
      const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
      std::nth_element(steps.begin(), middle, steps.end());
      if (!(*middle > 1 / fastest_fps)) continue;
      auto& [count, step] = votes[std::llround(100 / *middle)];
      ++count, step = *middle;
    }
  const auto most = std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) {
    return a.second.first < b.second.first;
  });
  return most == votes.end() ? std::nullopt : std::optional(most->second.second);
}

/// Frames are taken where the keys of most channels are; where those are thinned out, at the file's own rate,
/// or 60 in a second.
Status Skeletons::settle_times() {
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const SceneNode& node : nodes_)
    for (const std::vector<double>* times : {&node.translations.times_s, &node.rotations.times_s}) {
      if (times->empty()) continue;
      first = std::min(first, times->front()), last = std::max(last, times->back());
    }
  if (first > last) return Error{"holds no animation; export it with its animation baked", file_};
  if (!std::isfinite(first) || !std::isfinite(last)) return Error{"its key times are no numbers", file_};
  begin_s_ = first;
  const std::optional<double> step = step_of_most();
  fps_ = rate_.value_or(60);
  if (!step || last <= first) {
    frames_ = last > first ? static_cast<std::size_t>(std::llround((last - first) * fps_)) + 1 : 1;
    return Done{};
  }
  // Keys on every frame of the file's rate, or thinned out to every second or third one.
  const double frames_between = rate_ ? *step * *rate_ : 0;
  const bool on_frames = frames_between > 0.5 && std::abs(frames_between - std::round(frames_between)) < 0.01;
  const bool own_rate = !on_frames && *step < 0.08;
  if (own_rate) {
    // Median steps are exact to the digits of the file: rates within 0.05 % of a whole one are whole.
    const double rate = 1 / *step, whole = std::round(rate);
    fps_ = std::abs(rate - whole) < 5e-4 * whole ? whole : rate;
  }
  frames_ = static_cast<std::size_t>(std::llround((last - first) * fps_)) + 1;
  if (!own_rate && !(on_frames && frames_between < 1.5))
    warnings_.push_back({"sampled", 0,
                         "its keys are sparse or uneven; positions between them were found " +
                             exact_text(fps_) + " times a second"});
  return Done{};
}

std::vector<int> Skeletons::points_below(int root) const {
  std::vector<int> points, pending{root};
  while (!pending.empty()) {
    const int at = pending.back();
    pending.pop_back();
    const SceneNode& node = nodes_[index_of(at)];
    if (!node.is_helper && !node.is_other) points.push_back(at);
    const auto& children = children_[index_of(at)];
    for (auto child = children.rbegin(); child != children.rend(); ++child) pending.push_back(*child);
  }
  return points;
}

NamedMotion Skeletons::motion_below(int root) const {
  NamedMotion motion;
  const std::vector<int> points = points_below(root);
  std::vector<int> place(nodes_.size(), -1);
  for (const int node : points) {
    place[index_of(node)] = static_cast<int>(motion.points.size());
    motion.points.push_back(nodes_[index_of(node)].name);
    int parent = nodes_[index_of(node)].parent;
    while (parent >= 0 && place[index_of(parent)] < 0) parent = nodes_[index_of(parent)].parent;
    motion.parents.push_back(parent < 0 ? -1 : place[index_of(parent)]);
  }
  int named = root;
  // "Armature" over "Hips" is the better name of a performer.
  if (nodes_[index_of(root)].parent >= 0 && nodes_[index_of(nodes_[index_of(root)].parent)].parent >= 0)
    named = nodes_[index_of(root)].parent;
  motion.name = nodes_[index_of(named)].name;
  motion.fps = fps_;
  motion.warnings = warnings_;
  return motion;
}

void Skeletons::sample_frames(std::vector<NamedMotion>& motions,
                              const std::vector<std::vector<int>>& points) const {
  std::vector<Rest> rests;
  for (const SceneNode& node : nodes_) rests.push_back(rest_of(node));
  std::vector<Eigen::Affine3d> world(nodes_.size());
  for (std::size_t f = 0; f < frames_; ++f) {
    const double time = begin_s_ + static_cast<double>(f) / fps_;
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
      const SceneNode& node = nodes_[n];
      Eigen::Affine3d local = node.rest;
      if (animated(node) || !node.scales.times_s.empty()) {
        const Vec3 scale = node.scales.times_s.empty() ? rests[n].scale : sample(node.scales, time);
        const Eigen::Matrix3d rotation = node.rotations.times_s.empty()
                                             ? rests[n].rotation
                                             : sample(node.rotations, time).normalized().toRotationMatrix();
        local.linear() = rotation * scale.asDiagonal();
        local.translation() =
            node.translations.times_s.empty() ? rests[n].translation : sample(node.translations, time);
      }
      world[n] = node.parent < 0 ? local : world[index_of(node.parent)] * local;
    }
    for (std::size_t m = 0; m < motions.size(); ++m) {
      Positions& frame = motions[m].frames.emplace_back(static_cast<Eigen::Index>(points[m].size()), 3);
      for (std::size_t p = 0; p < points[m].size(); ++p)
        frame.row(static_cast<Eigen::Index>(p)) = world[index_of(points[m][p])].translation().transpose();
    }
  }
}

Result<std::vector<NamedMotion>> Skeletons::read() {
  if (nodes_.empty()) return Error{"holds no nodes", file_};
  find_relevant();
  std::vector<int> roots;
  for (std::size_t n = 0; n < nodes_.size(); ++n)
    if (nodes_[n].parent < 0) find_roots(static_cast<int>(n), roots);
  if (roots.empty())
    return Error{"holds no skeleton of at least " + std::to_string(fewest_nodes) +
                     " bones; export the armature with its animation",
                 file_};
  if (const Status times = settle_times(); !times) return times.error();
  std::vector<std::vector<int>> points;
  std::vector<NamedMotion> motions;
  std::size_t all = 0;
  for (const int root : roots) {
    points.push_back(points_below(root));
    motions.push_back(motion_below(root));
    all += points.back().size();
  }
  if (frames_ > most_positions / std::max<std::size_t>(1, all))
    return Error{"would have " + std::to_string(frames_) + " frames of " + std::to_string(all) +
                     " points, more than can be held; export a shorter range",
                 file_};
  sample_frames(motions, points);
  std::vector<NamedMotion> performers;
  for (NamedMotion& motion : motions)
    for (NamedMotion& performer : split_performers(std::move(motion), ":|"))
      performers.push_back(std::move(performer));
  std::vector<std::string> names;
  for (const NamedMotion& performer : performers) names.push_back(performer.name);
  make_names_unique(names, "performer", performers.front().warnings);
  for (std::size_t i = 0; i < names.size(); ++i) performers[i].name = names[i];
  for (NamedMotion& performer : performers) {
    strip_common_beginning(performer.points);
    make_names_unique(performer.points, "node", performer.warnings);
  }
  return performers;
}

}  // namespace

Result<std::vector<NamedMotion>> skeletons_of(const std::vector<SceneNode>& nodes, std::optional<double> rate,
                                              const std::string& file) {
  return Skeletons(nodes, rate, file).read();
}

}  // namespace abrazo
