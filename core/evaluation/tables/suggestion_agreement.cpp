#include "core/evaluation/tables/suggestion_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/annotation/suggestions.hpp"
#include "core/evaluation/tables/move_table.hpp"

namespace abrazo {

namespace {

constexpr double right_overlap = 0.5;  ///< intersection over union at which an interval is found

double overlap(const LabelInterval& a, const LabelInterval& b) {
  const double common = std::min(a.end, b.end) - std::max(a.start, b.start);
  return common <= 0 ? 0 : common / (std::max(a.end, b.end) - std::min(a.start, b.start));
}

bool agrees(const LabelInterval& truth, std::string_view label, bool lenient) {
  return truth.label == label || (lenient && !label.empty() && alternative_label(truth) == label);
}

/// Whether a true move was found, and by which.
const LabelInterval* finder(const LabelInterval& truth, const std::vector<LabelInterval>& proposed,
                            bool lenient) {
  for (const LabelInterval& candidate : proposed)
    if (overlap(truth, candidate) >= right_overlap && agrees(truth, candidate.label, lenient))
      return &candidate;
  return nullptr;
}

bool is_right(const LabelInterval& proposal, const std::vector<LabelInterval>& truth, bool lenient) {
  return std::any_of(truth.begin(), truth.end(), [&](const LabelInterval& t) {
    return overlap(t, proposal) >= right_overlap && agrees(t, proposal.label, lenient);
  });
}

/// Every frame said to be what is most frequent in the other takes.
std::vector<LabelInterval> majority_labels(const MotionLibrary& library, int take) {
  std::map<std::string, int> frames;
  for (std::size_t t = 0; t < library.takes().size(); ++t)
    if (static_cast<int>(t) != take)
      for (const LabelInterval& label : library.takes()[t].labels)
        frames[label.label] += label.end - label.start;
  if (frames.empty()) return {};
  const auto most =
      std::max_element(frames.begin(), frames.end(), [](auto& l, auto& r) { return l.second < r.second; });
  return {{0, library.takes()[static_cast<std::size_t>(take)].frames, most->first, "", ""}};
}

/// Every frame said to be what the nearest pose of the active performer in another take is labelled.
std::vector<LabelInterval> nearest_pose_labels(const MotionLibrary& library, int take) {
  std::vector<LabelInterval> runs;
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    if (static_cast<int>(library.source(pair).take) != take) continue;
    int best = -1;
    double least = std::numeric_limits<double>::infinity();
    for (int other = 0; other < library.pair_count(); ++other) {
      if (static_cast<int>(library.source(other).take) == take) continue;
      const double apart = (library.features(other) - library.features(pair)).squaredNorm();
      if (apart < least && !library.label(other).empty()) least = apart, best = other;
    }
    if (best < 0) return {};
    const int frame = static_cast<int>(library.source(pair).frame);
    const int next = frame + library.take_of(pair).frame_stride;
    if (!runs.empty() && frame < runs.back().end) continue;  // the same frame with roles exchanged
    if (!runs.empty() && runs.back().end == frame && runs.back().label == library.label(best))
      runs.back().end = next;
    else
      runs.push_back({frame, next, std::string(library.label(best)), "", ""});
  }
  return runs;
}

ActivePerformer role_at(const LibraryTake& take, int frame) {
  for (const RoleInterval& role : take.roles)
    if (frame >= role.start && frame < role.end) return role.active;
  return ActivePerformer::Unknown;
}

double f1_of(int found, int truths, int proposed) {
  return truths + proposed == 0 ? 0 : 2.0 * found / (truths + proposed);
}

void count_roles(const LibraryTake& take, const std::vector<Suggestion>& roles, SuggestionAgreement& sum,
                 SuggestionAgreement::TakeResult& result) {
  result.proposed_roles = static_cast<int>(roles.size());
  for (std::size_t r = 0; r < take.roles.size(); ++r)
    result.true_roles += take.roles[r].active != ActivePerformer::Unknown ? 1 : 0;
  for (const Suggestion& role : roles) {
    const ActivePerformer said = role.value == "a" ? ActivePerformer::A : ActivePerformer::B;
    long frames = 0, agreed = 0;
    for (int f = static_cast<int>(std::lround(role.start_s * take.fps));
         f < static_cast<int>(std::lround(role.end_s * take.fps)); ++f) {
      const ActivePerformer truth = role_at(take, f);
      if (truth == ActivePerformer::Unknown) continue;
      ++frames;
      agreed += truth == said ? 1 : 0;
    }
    result.role_frames += frames;
    result.role_agreed += agreed;
    if (frames > 0) sum.role_trials.push_back({role.confidence, 2 * agreed > frames, 2 * agreed > frames});
  }
}

}  // namespace

double LabelAgreement::frame_share() const {
  return frames == 0 ? 0 : static_cast<double>(agreed) / static_cast<double>(frames);
}
double LabelAgreement::lenient_frame_share() const {
  return frames == 0 ? 0 : static_cast<double>(agreed_lenient) / static_cast<double>(frames);
}
double LabelAgreement::f1() const {
  return f1_of(found, truths, proposed);
}
double LabelAgreement::lenient_f1() const {
  return f1_of(found_lenient, truths, proposed);
}

void LabelAgreement::add(const LabelAgreement& other) {
  frames += other.frames, agreed += other.agreed, agreed_lenient += other.agreed_lenient;
  truths += other.truths, proposed += other.proposed;
  found += other.found, found_lenient += other.found_lenient;
  boundary_errors.insert(boundary_errors.end(), other.boundary_errors.begin(), other.boundary_errors.end());
}

LabelAgreement label_agreement(const std::vector<LabelInterval>& truth,
                               const std::vector<LabelInterval>& proposed) {
  LabelAgreement sum;
  sum.truths = static_cast<int>(truth.size());
  sum.proposed = static_cast<int>(proposed.size());
  for (const LabelInterval& t : truth) {
    sum.frames += t.end - t.start;
    for (const LabelInterval& p : proposed) {
      const long common = std::max(0, std::min(t.end, p.end) - std::max(t.start, p.start));
      sum.agreed += agrees(t, p.label, false) ? common : 0;
      sum.agreed_lenient += agrees(t, p.label, true) ? common : 0;
    }
    if (const LabelInterval* by = finder(t, proposed, false)) {
      ++sum.found;
      sum.boundary_errors.push_back(std::abs(by->start - t.start));
      sum.boundary_errors.push_back(std::abs(by->end - t.end));
    }
    sum.found_lenient += finder(t, proposed, true) ? 1 : 0;
  }
  return sum;
}

LabelAgreement SuggestionAgreement::all(LabelAgreement TakeResult::*of) const {
  LabelAgreement sum;
  for (const TakeResult& take : takes) sum.add(take.*of);
  return sum;
}

double SuggestionAgreement::role_share() const {
  long frames = 0, agreed = 0;
  for (const TakeResult& take : takes) frames += take.role_frames, agreed += take.role_agreed;
  return frames == 0 ? 0 : static_cast<double>(agreed) / static_cast<double>(frames);
}

Result<SuggestionAgreement> measure_suggestions(const MotionLibrary& library, const Progress& progress) {
  SuggestionAgreement sum;
  std::vector<int> labelled;
  for (std::size_t t = 0; t < library.takes().size(); ++t)
    if (!library.takes()[t].labels.empty()) labelled.push_back(static_cast<int>(t));
  if (labelled.size() < 2)
    return Error{"agreement needs at least two labelled takes, each is suggested from the others",
                 library.name()};
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    const LibraryTake& take = library.takes()[static_cast<std::size_t>(labelled[i])];
    const double share = 1.0 / static_cast<double>(labelled.size());
    const auto suggested = suggest_annotations(
        library, {.take = take.name},
        part(progress, static_cast<double>(i) * share, static_cast<double>(i + 1) * share));
    if (!suggested) return suggested.error();
    std::vector<LabelInterval> proposed;
    for (const Suggestion& move : suggested->moves)
      proposed.push_back({static_cast<int>(std::lround(move.start_s * take.fps)),
                          static_cast<int>(std::lround(move.end_s * take.fps)), move.value, "", ""});
    SuggestionAgreement::TakeResult result;
    result.take = take.name;
    result.moves = label_agreement(take.labels, proposed);
    result.majority = label_agreement(take.labels, majority_labels(library, labelled[i]));
    result.nearest_pose = label_agreement(take.labels, nearest_pose_labels(library, labelled[i]));
    for (std::size_t p = 0; p < proposed.size(); ++p) {
      sum.move_trials.push_back({suggested->moves[p].confidence, is_right(proposed[p], take.labels, false),
                                 is_right(proposed[p], take.labels, true)});
      ++sum.labels[proposed[p].label].proposed;
    }
    for (const LabelInterval& truth : take.labels) {
      SuggestionAgreement::LabelCount& count = sum.labels[truth.label];
      ++count.truths;
      count.found += finder(truth, proposed, false) ? 1 : 0;
      count.found_lenient += finder(truth, proposed, true) ? 1 : 0;
      for (const LabelInterval& p : proposed)
        if (const int common = std::min(truth.end, p.end) - std::max(truth.start, p.start); common > 0)
          sum.confusion[{truth.label, p.label}] += common;
    }
    count_roles(take, suggested->roles, sum, result);
    sum.takes.push_back(std::move(result));
  }
  return sum;
}

std::vector<ReliabilityBin> reliability(const std::vector<SuggestionAgreement::Trial>& trials, int bins) {
  std::vector<ReliabilityBin> result(static_cast<std::size_t>(bins));
  for (const auto& trial : trials) {
    ReliabilityBin& bin =
        result[static_cast<std::size_t>(std::clamp(static_cast<int>(trial.confidence * bins), 0, bins - 1))];
    ++bin.count;
    bin.mean_confidence += trial.confidence;
    bin.right += trial.right ? 1 : 0;
    bin.right_lenient += trial.right_lenient ? 1 : 0;
  }
  for (ReliabilityBin& bin : result) {
    if (bin.count == 0) continue;
    bin.mean_confidence /= bin.count, bin.right /= bin.count, bin.right_lenient /= bin.count;
  }
  return result;
}

double calibration_error(const std::vector<ReliabilityBin>& bins) {
  double sum = 0, count = 0;
  for (const ReliabilityBin& bin : bins) {
    sum += bin.count * std::abs(bin.mean_confidence - bin.right);
    count += bin.count;
  }
  return count == 0 ? 0 : sum / count;
}

}  // namespace abrazo
