#include "core/library/build/pairing_guess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "core/base/text.hpp"
#include "core/library/takes/performer_name.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

constexpr double name_share = 0.5, length_share = 0.3, nearness_share = 0.2;
constexpr double least_evidence = 0.4, likely_evidence = 0.55, sure_evidence = 0.8;
constexpr double same_body_difference = 0.005;  ///< of a bone's length

/// How strongly a difference of names speaks for a pair, before the other names are looked at.
double weight_of(NameContrast contrast) {
  switch (contrast) {
    case NameContrast::Roles:
      return 1.0;
    case NameContrast::Letters:
      return 0.9;
    case NameContrast::Numbers:
      return 0.7;
    case NameContrast::Words:
      return 0.5;
    case NameContrast::None:
      return 0.0;
  }
  return 0.0;
}

/// The texts at one position of names with the same number of parts.
using ValuesAtPlace = std::map<std::pair<std::size_t, std::size_t>, std::set<std::string>>;

ValuesAtPlace values_in(std::span<const LonePerformer> performers) {
  ValuesAtPlace values;
  for (const LonePerformer& performer : performers) {
    const auto parts = parts_of_name(performer.file_name);
    for (std::size_t i = 0; i < parts.size(); ++i) values[{parts.size(), i}].insert(parts[i].text);
  }
  return values;
}

/// If only a number differs, it may be that of the subject or the take: there are fewer subjects than takes.
/// If nothing else varies, two values are two subjects and more values are takes.
double weight_among(const NameDifference& difference, std::size_t parts, const ValuesAtPlace& values) {
  const double weight = weight_of(difference.contrast), certainty = 0.2;
  if (difference.contrast != NameContrast::Numbers) return weight;
  std::size_t here = 0, elsewhere = 0;
  for (const auto& [place, texts] : values) {
    if (place.first != parts) continue;
    if (place.second == difference.part)
      here = texts.size();
    else if (texts.size() > 1)
      elsewhere = std::max(elsewhere, texts.size());
  }
  const std::size_t usual = elsewhere > 0 ? elsewhere : 3;
  return here < usual ? weight + certainty : here > usual || elsewhere == 0 ? weight - certainty : weight;
}

double length_evidence(const Clip& a, const Clip& b) {
  const auto frames_a = static_cast<double>(a.poses.size()), frames_b = static_cast<double>(b.poses.size());
  if (std::abs(a.fps - b.fps) > 1e-3 * a.fps) return 0;
  const double difference = std::abs(frames_a - frames_b) / std::max(frames_a, frames_b);
  if (difference == 0) return 1;
  return difference < 0.01 ? 0.5 : difference < 0.1 ? 0.2 : 0;
}

/// Median horizontal distance of the roots [m], over at most 60 frames that both have.
double usual_distance(const Clip& a, const Clip& b) {
  const std::size_t frames = std::min(a.poses.size(), b.poses.size());
  std::vector<double> distances;
  for (std::size_t f = 0; f < frames; f += std::max<std::size_t>(1, frames / 60)) {
    const Vec3 between = (b.poses[f].row(0) - a.poses[f].row(0)).transpose();
    distances.push_back(std::hypot(between.x(), between.z()));
  }
  if (distances.empty()) return 0;
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

double nearness_evidence(double distance_m) {
  if (distance_m < 0.15) return 0;  // each about its own origin, or one person twice
  return distance_m < 1.5 ? 1 : distance_m < 3 ? 0.6 : distance_m < 6 ? 0.2 : 0;
}

struct Evidence {
  double value = 0;
  std::optional<NameDifference> names;
  std::string reason;
  bool names_reversed = false;  ///< `names` is from b to a
};

double name_evidence(const LonePerformer& a, const LonePerformer& b, const ValuesAtPlace& values,
                     Evidence& evidence) {
  const bool one_file = a.file == b.file;
  const std::string& first = one_file ? a.name : a.file_name;
  const std::string& second = one_file ? b.name : b.file_name;
  evidence.names = difference_of_names(first, second);
  if (!evidence.names) {
    evidence.names = difference_of_names(second, first);
    evidence.names_reversed = evidence.names.has_value();
  }
  if (one_file && a.in_the_file == 2) {
    evidence.reason = "the two of one file";
    return 1;
  }
  if (!evidence.names) return 0;
  const NameDifference& names = *evidence.names;
  evidence.reason = names.one_more_part ? fmt::format("one name adds {}", names.second)
                                        : fmt::format("names differ in {}, {}", names.first, names.second);
  double weight = weight_among(names, parts_of_name(first).size(), values);
  if (!a.skeleton.empty() && a.skeleton == b.skeleton) weight *= 0.3;
  return weight;
}

Evidence weigh(const LonePerformer& a, const LonePerformer& b, const ValuesAtPlace& values) {
  Evidence evidence;
  const double names = name_evidence(a, b, values, evidence);
  const double lengths = length_evidence(*a.clip, *b.clip);
  if (names == 0 && lengths < 1) return evidence;  // nothing speaks for it: spares the measuring
  const double distance_m = usual_distance(*a.clip, *b.clip);
  const double nearness = nearness_evidence(distance_m);
  evidence.value = name_share * names + length_share * lengths + nearness_share * nearness;
  const auto add = [&](const std::string& words) {
    evidence.reason += (evidence.reason.empty() ? "" : "; ") + words;
  };
  add(lengths == 1 ? fmt::format("{} frames each", a.clip->poses.size())
                   : fmt::format("{} and {} frames", a.clip->poses.size(), b.clip->poses.size()));
  add(distance_m < 0.15 ? "on top of one another" : fmt::format("{:.2f} m apart", distance_m));
  const double difference =
      largest_length_difference(body_of(a.clip->poses.front()), body_of(b.clip->poses.front()));
  if (a.file != b.file && difference < same_body_difference) {
    evidence.value *= 0.8;
    add("the same bone lengths");
  }
  return evidence;
}

/// Names for the take: what the two names share.
std::string take_name(const LonePerformer& a, const LonePerformer& b, const Evidence& evidence) {
  if (a.file == b.file && a.in_the_file == 2) return a.file_name;
  std::string name;
  if (evidence.names)
    name = shared_name(evidence.names_reversed ? b.file_name : a.file_name, *evidence.names);
  if (name.empty()) return a.file_name + "+" + b.file_name;
  const bool only_digits = name.find_first_not_of("0123456789_- ") == std::string::npos;
  return only_digits ? "take_" + name : name;
}

struct Candidate {
  std::size_t a, b;
  Evidence evidence;
};

PairGuess guess_from(const Candidate& candidate, std::span<const LonePerformer> performers,
                     std::set<std::string>& names) {
  PairGuess guess;
  guess.a = candidate.a, guess.b = candidate.b;
  const auto& difference = candidate.evidence.names;
  if (difference && difference->contrast == NameContrast::Roles) {
    guess.roles_known = true;
    if (difference->first_is_active == candidate.evidence.names_reversed) std::swap(guess.a, guess.b);
  }
  guess.evidence = std::min(1.0, candidate.evidence.value);
  guess.reason = candidate.evidence.reason;
  const std::string wanted = take_name(performers[candidate.a], performers[candidate.b], candidate.evidence);
  guess.take = wanted;
  for (int n = 2; !names.insert(guess.take).second; ++n) guess.take = fmt::format("{}_{}", wanted, n);
  return guess;
}

/// A name without letter case and separators.
std::string plain(std::string_view name) {
  std::string text;
  for (const NamePart& part : parts_of_name(name)) text += part.text + " ";
  return text;
}

std::string last_number(std::string_view name) {
  const auto parts = parts_of_name(name);
  if (parts.empty() || parts.back().text.find_first_not_of("0123456789") != std::string::npos) return {};
  const auto digits = parts.back().text.find_first_not_of('0');
  return digits == std::string::npos ? "0" : parts.back().text.substr(digits);
}

}  // namespace

Confidence PairGuess::confidence() const {
  return evidence >= sure_evidence     ? Confidence::Sure
         : evidence >= likely_evidence ? Confidence::Likely
                                       : Confidence::Unsure;
}

std::vector<PairGuess> guess_pairs(std::span<const LonePerformer> performers) {
  const ValuesAtPlace values = values_in(performers);
  std::vector<Candidate> candidates;
  for (std::size_t a = 0; a < performers.size(); ++a)
    for (std::size_t b = a + 1; b < performers.size(); ++b) {
      Evidence evidence = weigh(performers[a], performers[b], values);
      if (evidence.value >= least_evidence || performers.size() == 2)
        candidates.push_back({a, b, std::move(evidence)});
    }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& one, const Candidate& other) {
    return one.evidence.value > other.evidence.value + 1e-9;
  });
  std::vector<bool> taken(performers.size(), false);
  std::vector<PairGuess> guesses;
  std::set<std::string> names;
  for (const Candidate& candidate : candidates) {
    if (taken[candidate.a] || taken[candidate.b]) continue;
    taken[candidate.a] = taken[candidate.b] = true;
    guesses.push_back(guess_from(candidate, performers, names));
  }
  std::stable_sort(guesses.begin(), guesses.end(), [](const PairGuess& one, const PairGuess& other) {
    return std::min(one.a, one.b) < std::min(other.a, other.b);
  });
  return guesses;
}

std::string guess_skeleton(const std::string& motion, std::span<const std::string> skeletons) {
  for (std::string name = fs::path(motion).stem().string(); !name.empty();) {
    for (const std::string& skeleton : skeletons)
      if (fs::path(skeleton).stem() == name) return skeleton;
    const auto cut = name.rfind('_');
    name.resize(cut == std::string::npos ? 0 : cut);
  }
  return skeletons.size() == 1 ? skeletons.front() : std::string();
}

std::string guess_labelled_take(const std::string& take, std::span<const std::string> labelled) {
  for (const std::string& name : labelled)
    if (plain(name) == plain(take)) return name;
  const std::string number = last_number(take);
  std::string found;
  for (const std::string& name : labelled) {
    if (number.empty() || last_number(name) != number) continue;
    if (!found.empty()) return {};
    found = name;
  }
  return found;
}

}  // namespace abrazo
