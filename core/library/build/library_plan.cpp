#include "core/library/build/library_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <map>
#include <stdexcept>

namespace abrazo {

namespace {

constexpr double smallest_m = 1.0, tallest_m = 2.3;  ///< standing heights that raise no question
constexpr double farthest_couple_m = 6.0;

std::string file_of(const PlannedPerformer& performer) {
  const std::string file = performer.source.motion.filename().string();
  return performer.in_the_file > 1 ? file + ", " + performer.name : file;
}

/// Indices of the performers of each take, in the order of the plan.
std::map<std::string, std::vector<int>> takes_of(const LibraryPlan& plan) {
  std::map<std::string, std::vector<int>> takes;
  for (std::size_t i = 0; i < plan.performers.size(); ++i)
    if (!plan.performers[i].take.empty()) takes[plan.performers[i].take].push_back(static_cast<int>(i));
  return takes;
}

PlannedPerformer& at(LibraryPlan& plan, int index) {
  return plan.performers[static_cast<std::size_t>(index)];
}
const PlannedPerformer& at(const LibraryPlan& plan, int index) {
  return plan.performers[static_cast<std::size_t>(index)];
}

/// Those of a take one after the other where the first of them stood, the leading one first.
void bring_together(LibraryPlan& plan) {
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < plan.performers.size(); ++i)
    if (!plan.performers[i].take.empty()) places.emplace(plan.performers[i].take, i);
  std::vector<std::pair<std::pair<std::size_t, int>, PlannedPerformer>> keyed;
  for (std::size_t i = 0; i < plan.performers.size(); ++i) {
    PlannedPerformer& performer = plan.performers[i];
    const std::size_t place = performer.take.empty() ? i : places.at(performer.take);
    keyed.emplace_back(std::pair(place, performer.role == PlannedRole::Follows ? 1 : 0),
                       std::move(performer));
  }
  std::stable_sort(keyed.begin(), keyed.end(),
                   [](const auto& one, const auto& other) { return one.first < other.first; });
  for (std::size_t i = 0; i < keyed.size(); ++i) plan.performers[i] = std::move(keyed[i].second);
}

LonePerformer lone(const PlannedPerformer& performer) {
  return {performer.source.motion.string(), performer.name, performer.source.skeleton.string(),
          performer.clip.get(), static_cast<std::size_t>(performer.in_the_file)};
}

// ---- remarks ----

/// The reader's warnings about facts that a file cannot state.
bool is_question(const ImportWarning& warning) {
  return warning.kind == "fps" || warning.kind == "units";
}

void remark_on_performer(const PlannedPerformer& performer, int index, std::vector<PlanRemark>& remarks) {
  using Kind = PlanRemark::Kind;
  const auto add = [&](Kind kind, const std::string& text, Hint hint = Hint::None) {
    remarks.push_back({kind, index, file_of(performer), text, hint});
  };
  if (performer.trouble) {
    remarks.push_back({performer.take.empty() ? Kind::Warning : Kind::Obstacle, index, "",
                       performer.trouble->text(), performer.trouble->hint});
    return;
  }
  if (performer.take.empty())
    return add(Kind::Warning, "is in no take and is left out; give it the take of its partner to use it");
  const double height = performer.report.height_m;
  if (height < smallest_m || height > tallest_m)
    add(Kind::Question, fmt::format("would stand {:.2f} m tall; set its unit", height));
  for (const ImportWarning& warning : performer.report.warnings)
    if (warning.kind != "height")
      add(is_question(warning) ? Kind::Question : Kind::Warning,
          (warning.line > 0 ? fmt::format("line {}: ", warning.line) : "") + warning.detail, warning.hint);
}

/// Median horizontal distance of two roots [m], over the frames that are used.
double distance_in_take(const PlannedPerformer& a, const PlannedPerformer& b, int frames) {
  std::vector<double> distances;
  for (int f = 0; f < frames; f += std::max(1, frames / 60)) {
    const Pose& first = a.clip->poses[static_cast<std::size_t>(a.source.start + f)];
    const Pose& second = b.clip->poses[static_cast<std::size_t>(b.source.start + f)];
    distances.push_back(std::hypot(first(0, 0) - second(0, 0), first(0, 2) - second(0, 2)));
  }
  if (distances.empty()) return 0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

void remark_on_pair(const LibraryPlan& plan, const std::string& take, int a, int b,
                    std::vector<PlanRemark>& remarks) {
  const PlannedPerformer &first = at(plan, a), &second = at(plan, b);
  if (!first.clip || !second.clip) return;
  const auto add = [&](PlanRemark::Kind kind, const std::string& text) {
    remarks.push_back({kind, a, "take " + take, text});
  };
  using Kind = PlanRemark::Kind;
  if (first.source.motion == second.source.motion && first.source.index == second.source.index)
    add(Kind::Obstacle, "both performers are the same one of the same file; name the other one's");
  if ((first.role == second.role) && first.role != PlannedRole::Either)
    add(Kind::Obstacle, "both have the same role; one leads and one follows, or say \"either\" for both");
  if (std::abs(first.report.fps - second.report.fps) > 1e-3 * first.report.fps)
    add(Kind::Obstacle, fmt::format("{:.4g} and {:.4g} frames per second; give both the same",
                                    first.report.fps, second.report.fps));
  if (first.role == PlannedRole::Either)
    add(Kind::Question,
        "nothing says who leads: both assignments are kept, and the library doubles; set the role of one");
  if (first.guess && first.guess->confidence() == Confidence::Unsure)
    add(Kind::Question, "are these two one pair? " + first.guess->reason);
  const int frames = used_frames(plan, a);
  const int longer = std::max(first.frames() - first.source.start, second.frames() - second.source.start);
  if (frames < 2) {
    add(Kind::Obstacle, "fewer than 2 frames are left of both; give earlier first frames");
    return;
  }
  if (longer != frames)
    add(Kind::Warning, fmt::format("one performer has {} frames more; the first {} of both are used. Where "
                                   "one began earlier, set its first frame",
                                   longer - frames, frames));
  const double distance = distance_in_take(first, second, frames);
  if (distance > farthest_couple_m)
    add(Kind::Warning,
        fmt::format("they are {:.1f} m apart (median); are they one pair, in one unit?", distance));
  else if (distance < 0.15)
    add(Kind::Warning, "they stand on top of one another; each seems to be recorded about a separate origin");
}

void remark_on_labels(const LibraryPlan& plan, const std::string& take, int performer,
                      std::vector<PlanRemark>& remarks) {
  const auto& names = plan.labelled_takes;
  if (plan.labels.empty() || std::find(names.begin(), names.end(), take) != names.end()) return;
  std::string known;
  for (std::size_t i = 0; i < std::min<std::size_t>(names.size(), 4); ++i)
    known += (i > 0 ? ", " : "") + names[i];
  remarks.push_back({PlanRemark::Kind::Warning, performer, "take " + take,
                     fmt::format("{} has no labels of it, but of {}{}; rename the take to use them",
                                 plan.labels.filename().string(), known.empty() ? "none" : known,
                                 names.size() > 4 ? ", ..." : "")});
}

// ---- the manifest ----

Manifest::Performer settled(const PlannedPerformer& performer, const PlannedPerformer& partner) {
  Manifest::Performer settled = with_space_of(partner.report, performer.report, performer.source);
  if (performer.in_the_file < 2) settled.index.reset();
  if (!settled.metres_per_unit) settled.metres_per_unit = performer.report.metres_per_unit;
  if (!settled.up_axis) settled.up_axis = performer.report.up_axis;
  // What was found from the bones or names of this file has no name to read it by.
  if (settled.joint_map.empty() && is_builtin_joint_map(performer.report.joint_map))
    settled.joint_map = performer.report.joint_map;
  return settled;
}

}  // namespace

void pair_up(LibraryPlan& plan) {
  std::vector<std::size_t> free;
  std::vector<LonePerformer> performers;
  for (std::size_t i = 0; i < plan.performers.size(); ++i)
    if (plan.performers[i].take.empty() && plan.performers[i].clip) {
      free.push_back(i);
      performers.push_back(lone(plan.performers[i]));
    }
  const auto takes = takes_of(plan);
  for (PairGuess guess : guess_pairs(performers)) {
    const std::string wanted = guess.take;
    for (int n = 2; takes.contains(guess.take); ++n) guess.take = fmt::format("{}_{}", wanted, n);
    for (const std::size_t which : {guess.a, guess.b}) {
      PlannedPerformer& performer = plan.performers[free[which]];
      performer.take = guess.take;
      performer.guess = guess;
      if (guess.roles_known) performer.role = which == guess.a ? PlannedRole::Leads : PlannedRole::Follows;
    }
  }
  bring_together(plan);
}

void name_like_labels(LibraryPlan& plan) {
  std::map<std::string, std::string> renamed;
  for (const auto& [take, performers] : takes_of(plan)) {
    const std::string name = guess_labelled_take(take, plan.labelled_takes);
    const bool free =
        std::none_of(renamed.begin(), renamed.end(), [&](const auto& other) { return other.second == name; });
    if (!name.empty() && free) renamed[take] = name;
  }
  for (PlannedPerformer& performer : plan.performers)
    if (const auto found = renamed.find(performer.take); found != renamed.end())
      performer.take = found->second;
}

int partner_of(const LibraryPlan& plan, int performer) {
  const std::string& take = at(plan, performer).take;
  if (take.empty()) return -1;
  int partner = -1;
  for (int i = 0; i < static_cast<int>(plan.performers.size()); ++i) {
    if (i == performer || at(plan, i).take != take) continue;
    if (partner >= 0) return -1;
    partner = i;
  }
  return partner;
}

void set_take(LibraryPlan& plan, int performer, const std::string& take) {
  if (const int before = partner_of(plan, performer); before >= 0) at(plan, before).guess.reset();
  at(plan, performer).take = take;
  at(plan, performer).guess.reset();
  const int partner = partner_of(plan, performer);
  if (partner < 0) return;
  at(plan, partner).guess.reset();
  set_role(plan, partner, at(plan, partner).role);
}

void set_role(LibraryPlan& plan, int performer, PlannedRole role) {
  at(plan, performer).role = role;
  const int partner = partner_of(plan, performer);
  if (partner < 0) return;
  at(plan, partner).role = role == PlannedRole::Either  ? PlannedRole::Either
                           : role == PlannedRole::Leads ? PlannedRole::Follows
                                                        : PlannedRole::Leads;
}

int used_frames(const LibraryPlan& plan, int performer) {
  const int partner = partner_of(plan, performer);
  if (partner < 0) return 0;
  const PlannedPerformer &a = at(plan, performer), &b = at(plan, partner);
  return std::max(0, std::min(a.frames() - a.source.start, b.frames() - b.source.start));
}

std::vector<PlanRemark> remarks_on(const LibraryPlan& plan) {
  std::vector<PlanRemark> remarks;
  for (std::size_t i = 0; i < plan.performers.size(); ++i)
    remark_on_performer(plan.performers[i], static_cast<int>(i), remarks);
  const auto takes = takes_of(plan);
  for (const auto& [take, performers] : takes) {
    if (performers.size() == 2) {
      remark_on_pair(plan, take, performers[0], performers[1], remarks);
      remark_on_labels(plan, take, performers[0], remarks);
      continue;
    }
    remarks.push_back({PlanRemark::Kind::Obstacle, performers[0], "take " + take,
                       fmt::format("has {} performer{}; a take has two", performers.size(),
                                   performers.size() == 1 ? "" : "s")});
  }
  if (takes.empty())
    remarks.push_back(
        {PlanRemark::Kind::Obstacle, -1, "",
         plan.performers.empty()
             ? "no motion yet: add the files of performers who were captured together"
             : "no take yet: give two performers the same take, those who were captured together"});
  if (plan.name.empty())
    remarks.push_back({PlanRemark::Kind::Obstacle, -1, "", "the library has no name; give it one"});
  std::stable_sort(remarks.begin(), remarks.end(),
                   [](const PlanRemark& one, const PlanRemark& other) { return one.kind > other.kind; });
  return remarks;
}

std::vector<PlanRemark> brought_together(const std::vector<PlanRemark>& remarks) {
  std::vector<PlanRemark> all;
  std::vector<int> others;
  for (const PlanRemark& remark : remarks) {
    const auto same = std::find_if(all.begin(), all.end(), [&](const PlanRemark& known) {
      return known.kind == remark.kind && known.text == remark.text;
    });
    if (same == all.end()) {
      all.push_back(remark);
      others.push_back(0);
    } else {
      ++others[static_cast<std::size_t>(same - all.begin())];
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (others[i] > 0) all[i].about += fmt::format(" and {} more", others[i]);
  return all;
}

Manifest manifest_of(const LibraryPlan& plan) {
  for (const PlanRemark& remark : remarks_on(plan))
    if (remark.kind == PlanRemark::Kind::Obstacle) throw std::invalid_argument(remark.whole());
  Manifest manifest;
  manifest.name = plan.name;
  for (int i = 0; i < static_cast<int>(plan.performers.size()); ++i) {
    const int partner = partner_of(plan, i);
    if (partner < i) continue;  // in no take, or reported already
    const PlannedPerformer &a = at(plan, i), &b = at(plan, partner);
    Manifest::Take take;
    take.name = a.take;
    take.fps = a.report.fps;
    take.a = settled(a, b), take.b = settled(b, a);
    const int frames = used_frames(plan, i);
    if (frames != a.frames() - a.source.start || frames != b.frames() - b.source.start) take.frames = frames;
    if (a.role == PlannedRole::Leads) take.roles = {{0, INT_MAX, ActivePerformer::A}};
    if (a.role == PlannedRole::Follows) take.roles = {{0, INT_MAX, ActivePerformer::B}};
    const auto& labelled = plan.labelled_takes;
    if (std::find(labelled.begin(), labelled.end(), take.name) != labelled.end()) take.labels = plan.labels;
    manifest.takes.push_back(std::move(take));
  }
  return manifest;
}

}  // namespace abrazo
