#include "core/library/build/pairing_guess.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "core/library/takes/performer_name.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

namespace {

namespace fs = std::filesystem;

constexpr double name_share = 0.5, length_share = 0.3, nearness_share = 0.2;
constexpr double least_evidence = 0.4, likely_evidence = 0.55, sure_evidence = 0.8;
constexpr double unsure_evidence = likely_evidence - 0.01;
constexpr double rival_margin = 0.1;            ///< another guess as near as this leaves both open
constexpr double same_body_difference = 0.005;  ///< of a bone's length
constexpr double inside_one_another_m = 0.15;   ///< distance of roots that two bodies cannot have
constexpr double declared_weight = 0.9;         ///< of a difference that names performers by itself

/// How strongly a difference of names speaks for a pair, before the other names are looked at.
double weight_of(const NameDifference& names) {
  switch (names.contrast) {
    case NameContrast::Roles:
      return names.also_numbers ? 0.7 : 1.0;
    case NameContrast::Performers:
      return 0.95;
    case NameContrast::Letters: {
      const auto [first, second] = std::minmax(names.first, names.second);
      return first == "a" && second == "b" ? declared_weight : 0.7;
    }
    case NameContrast::Numbers:
      return 0.7;
    case NameContrast::Words:
      return 0.5;
    case NameContrast::None:
      return 0.0;
  }
  return 0.0;
}

/// The part at which paths with the same number of parts differ.
using Place = std::pair<std::size_t, std::size_t>;

/// Files of two values at one place.
struct Reading {
  std::size_t pairs = 0, of_equal_length = 0;
};

/// All paths with their parts, and what varies among them.
struct Names {
  std::vector<std::string> paths;  ///< below the folder that all share, without extension
  std::vector<std::vector<NamePart>> parts;
  std::map<Place, std::set<std::string>> values;
  std::map<std::size_t, std::size_t> files;  ///< by the number of parts
  std::map<std::pair<Place, std::pair<std::string, std::string>>, Reading> readings;
  std::map<std::size_t, std::pair<double, std::size_t>> declared;  ///< weight and part of the strongest
                                                                   ///< difference that most files have
  bool one_body = false;                                           ///< all have the same bone lengths
};

std::pair<Place, std::pair<std::string, std::string>> reading_of(const NameDifference& difference,
                                                                 std::size_t parts) {
  const auto [first, second] = std::minmax(difference.first, difference.second);
  return {{parts, difference.part}, {first, second}};
}

std::vector<std::string> paths_below_the_common_folder(std::span<const LonePerformer> performers) {
  std::vector<fs::path> paths;
  for (const LonePerformer& performer : performers) paths.emplace_back(performer.file);
  fs::path common = paths.empty() ? fs::path() : paths.front().parent_path();
  for (const fs::path& path : paths)
    while (!common.empty() && std::ranges::mismatch(common, path).in1 != common.end())
      common = common.has_relative_path() ? common.parent_path() : fs::path();
  std::vector<std::string> below;
  for (const fs::path& path : paths)
    below.push_back((common.empty() ? fs::path(path) : path.lexically_relative(common))
                        .replace_extension()
                        .generic_string());
  return below;
}

bool have_one_body(std::span<const LonePerformer> performers) {
  if (performers.size() < 3) return false;
  const Body first = body_of(performers.front().clip->poses.front());
  return std::ranges::all_of(performers, [&](const LonePerformer& performer) {
    return largest_length_difference(first, body_of(performer.clip->poses.front())) < same_body_difference;
  });
}

Names names_of(std::span<const LonePerformer> performers) {
  Names names;
  names.paths = paths_below_the_common_folder(performers);
  names.one_body = have_one_body(performers);
  for (const std::string& path : names.paths) {
    names.parts.push_back(parts_of_name(path));
    const auto& parts = names.parts.back();
    ++names.files[parts.size()];
    for (std::size_t i = 0; i < parts.size(); ++i) names.values[{parts.size(), i}].insert(parts[i].text);
  }
  for (std::size_t a = 0; a < performers.size(); ++a)
    for (std::size_t b = a + 1; b < performers.size(); ++b) {
      const auto difference = difference_of_names(names.parts[a], names.parts[b]);
      if (!difference || difference->one_more_part) continue;
      Reading& reading = names.readings[reading_of(*difference, names.parts[a].size())];
      ++reading.pairs;
      if (performers[a].clip->poses.size() == performers[b].clip->poses.size()) ++reading.of_equal_length;
      // Roles name performers, whether or not these are numbered as well.
      const double says = difference->contrast == NameContrast::Roles ? 1.0 : weight_of(*difference);
      auto& [weight, part] = names.declared[names.parts[a].size()];
      if (says >= declared_weight && says > weight && 4 * reading.pairs >= names.files[names.parts[a].size()])
        weight = says, part = difference->part;
    }
  return names;
}

/// If only a number differs, it may be that of the subject or the take: there are fewer subjects than takes.
/// If nothing else varies, two values are two subjects and more values are takes. Where most files name their
/// performers elsewhere, any difference is that of takes.
double weight_among(const NameDifference& difference, std::size_t parts, const Names& names) {
  double weight = weight_of(difference);
  const double certainty = 0.2, elsewhere_declared = 0.3;
  if (const auto declared = names.declared.find(parts); declared != names.declared.end() &&
                                                        declared->second.first > weight &&
                                                        declared->second.second != difference.part)
    weight -= elsewhere_declared;
  if (difference.contrast != NameContrast::Numbers) return weight;
  std::size_t here = 0, elsewhere = 0;
  for (const auto& [place, texts] : names.values) {
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

/// Horizontal distances of the roots [m], ascending, over at most 60 frames that both have.
std::vector<double> distances_of(const Clip& a, const Clip& b) {
  const std::size_t frames = std::min(a.poses.size(), b.poses.size());
  std::vector<double> distances;
  for (std::size_t f = 0; f < frames; f += std::max<std::size_t>(1, frames / 60)) {
    const Vec3 between = (b.poses[f].row(0) - a.poses[f].row(0)).transpose();
    distances.push_back(std::hypot(between.x(), between.z()));
  }
  std::ranges::sort(distances);
  return distances;
}

double nearness_evidence(double distance_m) {
  if (distance_m < inside_one_another_m) return 0;  // each about its own origin, or one person twice
  return distance_m < 1.5 ? 1 : distance_m < 3 ? 0.6 : distance_m < 6 ? 0.2 : 0;
}

struct Evidence {
  double value = 0;
  std::optional<NameDifference> names;
  std::string reason;
  bool names_reversed = false;  ///< `names` is from b to a

  void add(const std::string& words) { reason += (reason.empty() ? "" : "; ") + words; }
  void doubt() { value = std::min(value, unsure_evidence); }
};

/// Whether lengths of takes confirm that a difference which says little is that of performers.
bool is_confirmed(const NameDifference& difference, std::size_t parts, const Names& names) {
  const auto found = names.readings.find(reading_of(difference, parts));
  if (found == names.readings.end()) return false;
  const bool by_one_take = difference.contrast != NameContrast::Words;
  return 2 * found->second.of_equal_length >= found->second.pairs && (by_one_take || found->second.pairs > 1);
}

/// Performers and what speaks for a pair of them.
class Weighing {
 public:
  explicit Weighing(std::span<const LonePerformer> performers)
      : performers_(performers), names_(names_of(performers)) {}

  Evidence of(std::size_t a, std::size_t b) const;
  /// The common part of both paths, below the common folder.
  std::string shared_path(std::size_t a, std::size_t b, const Evidence& evidence) const {
    if (performers_[a].file == performers_[b].file) return names_.paths[a];
    if (evidence.names) return shared_name(names_.paths[evidence.names_reversed ? b : a], *evidence.names);
    return names_.paths[a] + "+" + fs::path(names_.paths[b]).filename().string();
  }

 private:
  double by_names(std::size_t a, std::size_t b, Evidence& evidence) const;
  void doubt_lengths(std::size_t a, std::size_t b, double weight, Evidence& evidence) const;

  std::span<const LonePerformer> performers_;
  Names names_;
};

double Weighing::by_names(std::size_t a, std::size_t b, Evidence& evidence) const {
  const LonePerformer &one = performers_[a], &other = performers_[b];
  const bool one_file = one.file == other.file;
  const std::vector<NamePart> first = one_file ? parts_of_name(one.name) : names_.parts[a];
  const std::vector<NamePart> second = one_file ? parts_of_name(other.name) : names_.parts[b];
  evidence.names = difference_of_names(first, second);
  if (!evidence.names) {
    evidence.names = difference_of_names(second, first);
    evidence.names_reversed = evidence.names.has_value();
  }
  if (one_file && one.in_the_file == 2) {
    evidence.reason = "the two of one file";
    return 1;
  }
  if (!evidence.names) return 0;
  const NameDifference& names = *evidence.names;
  evidence.reason = names.one_more_part ? fmt::format("one name adds {}", names.second)
                                        : fmt::format("names differ in {}, {}", names.first, names.second);
  double weight = one_file ? weight_of(names) : weight_among(names, first.size(), names_);
  if (!one.skeleton.empty() && one.skeleton == other.skeleton) weight *= 0.3;
  return weight;
}

/// A name that says little needs equal lengths, and one that says much half of the longer.
void Weighing::doubt_lengths(std::size_t a, std::size_t b, double weight, Evidence& evidence) const {
  const auto frames_a = static_cast<double>(performers_[a].clip->poses.size()),
             frames_b = static_cast<double>(performers_[b].clip->poses.size());
  const double common = std::min(frames_a, frames_b) / std::max(frames_a, frames_b);
  const bool declared =
      weight >= declared_weight && evidence.names && weight_of(*evidence.names) >= declared_weight;
  const bool confirmed =
      declared || performers_[a].file == performers_[b].file ||
      (evidence.names &&
       (evidence.names->one_more_part ? common == 1
                                      : is_confirmed(*evidence.names, names_.parts[a].size(), names_)));
  if (!confirmed || common < (declared ? 0.5 : 0.9)) evidence.doubt();
}

Evidence Weighing::of(std::size_t a, std::size_t b) const {
  const Clip &one = *performers_[a].clip, &other = *performers_[b].clip;
  Evidence evidence;
  const auto has_its_own = [](const LonePerformer& performer) { return performer.in_the_file == 2; };
  const bool one_file = performers_[a].file == performers_[b].file;
  if (!one_file && (has_its_own(performers_[a]) || has_its_own(performers_[b]))) return evidence;
  const double names = by_names(a, b, evidence);
  const double lengths = length_evidence(one, other);
  if (names == 0 && lengths < 1) return evidence;  // nothing speaks for it: spares the measuring
  const std::vector<double> distances = distances_of(one, other);
  const double distance_m = distances.empty() ? 0 : distances[distances.size() / 2];
  evidence.value =
      name_share * names + length_share * lengths + nearness_share * nearness_evidence(distance_m);
  evidence.add(lengths == 1 ? fmt::format("{} frames each", one.poses.size())
                            : fmt::format("{} and {} frames", one.poses.size(), other.poses.size()));
  evidence.add(distance_m < inside_one_another_m ? "on top of one another"
                                                 : fmt::format("{:.2f} m apart", distance_m));
  if (!one_file && !names_.one_body &&
      largest_length_difference(body_of(one.poses.front()), body_of(other.poses.front())) <
          same_body_difference) {
    evidence.value *= 0.8;
    evidence.add("the same bone lengths");
  }
  doubt_lengths(a, b, names, evidence);
  if (std::abs(one.fps - other.fps) > 1e-3 * one.fps) {
    evidence.add(fmt::format("{:.4g} and {:.4g} frames per second", one.fps, other.fps));
    evidence.doubt();
  }
  // A tenth of the frames in one another is no embrace.
  if (distances.empty() || distances[distances.size() / 10] < inside_one_another_m) evidence.doubt();
  return evidence;
}

struct Candidate {
  std::size_t a, b;
  Evidence evidence;
};

/// "s_1/x" -> "x", or "s_1_x" with one folder more.
std::string end_of_path(const std::string& path, std::size_t folders) {
  std::vector<std::string> names;
  for (const fs::path& name : fs::path(path)) names.push_back(name.string());
  std::string text;
  for (std::size_t i = names.size() - std::min(names.size(), folders + 1); i < names.size(); ++i)
    for (const char c : (text.empty() ? "" : "_") + names[i]) {
      const auto byte = static_cast<unsigned char>(c);
      const bool joint = text.empty() || text.back() == '_';
      const bool plain =
          std::isalnum(byte) != 0 || byte >= 128 || c == '-' || (!joint && (c == '.' || c == '+'));
      if (plain || !joint) text += plain ? c : '_';
    }
  return text;
}

/// Names what both paths share: by the file, with as many folders as make the names differ.
void name_takes(std::vector<PairGuess>& guesses, const std::vector<std::string>& shared_paths) {
  const auto only_digits = [](const std::string& name) {
    return name.find_first_not_of("0123456789_- ") == std::string::npos;
  };
  const auto depth = [&](std::size_t g) { return std::ranges::count(shared_paths[g], '/'); };
  for (std::size_t g = 0; g < guesses.size(); ++g)
    guesses[g].take = end_of_path(shared_paths[g], only_digits(end_of_path(shared_paths[g], 0)) ? 1 : 0);
  for (std::size_t folders = 1; folders < 12; ++folders) {
    std::map<std::string, int> uses;
    for (const PairGuess& guess : guesses) ++uses[guess.take];
    for (std::size_t g = 0; g < guesses.size(); ++g)
      if (uses[guesses[g].take] > 1 && depth(g) >= static_cast<std::ptrdiff_t>(folders))
        guesses[g].take = end_of_path(shared_paths[g], folders);
  }
  std::set<std::string> taken;
  for (PairGuess& guess : guesses) {
    if (only_digits(guess.take)) guess.take = guess.take.empty() ? "take" : "take_" + guess.take;
    const std::string wanted = guess.take;
    for (int n = 2; !taken.insert(guess.take).second; ++n) guess.take = fmt::format("{}_{}", wanted, n);
  }
}

PairGuess guess_from(const Candidate& candidate) {
  PairGuess guess;
  guess.a = candidate.a, guess.b = candidate.b;
  const auto& difference = candidate.evidence.names;
  if (difference && difference->contrast == NameContrast::Roles) {
    guess.roles_known = true;
    if (difference->first_is_active == candidate.evidence.names_reversed) std::swap(guess.a, guess.b);
  }
  guess.evidence = std::min(1.0, candidate.evidence.value);
  guess.reason = candidate.evidence.reason;
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
  const Weighing weighing(performers);
  std::vector<Candidate> candidates;
  std::vector<std::vector<std::size_t>> candidates_of(performers.size());
  for (std::size_t a = 0; a < performers.size(); ++a)
    for (std::size_t b = a + 1; b < performers.size(); ++b) {
      Evidence evidence = weighing.of(a, b);
      if (evidence.value >= least_evidence || performers.size() == 2)
        candidates.push_back({a, b, std::move(evidence)});
    }
  std::stable_sort(candidates.begin(), candidates.end(), [](const Candidate& one, const Candidate& other) {
    return one.evidence.value > other.evidence.value + 1e-9;
  });
  for (std::size_t c = 0; c < candidates.size(); ++c)
    for (const std::size_t performer : {candidates[c].a, candidates[c].b})
      candidates_of[performer].push_back(c);
  enum class Use { Free, Open, Settled };
  std::vector<Use> uses(performers.size(), Use::Free);
  const auto has_rival = [&](std::size_t c) {
    const auto is_rival = [&](std::size_t other) {
      return other != c && uses[candidates[other].a] != Use::Settled &&
             uses[candidates[other].b] != Use::Settled &&
             candidates[other].evidence.value > candidates[c].evidence.value - rival_margin;
    };
    return std::ranges::any_of(candidates_of[candidates[c].a], is_rival) ||
           std::ranges::any_of(candidates_of[candidates[c].b], is_rival);
  };
  std::vector<PairGuess> guesses;
  std::vector<std::string> shared_paths;
  std::vector<std::size_t> chosen;
  for (std::size_t c = 0; c < candidates.size(); ++c) {
    Candidate& candidate = candidates[c];
    if (uses[candidate.a] != Use::Free || uses[candidate.b] != Use::Free) continue;
    if (candidate.evidence.value >= likely_evidence && has_rival(c)) {
      candidate.evidence.doubt();
      candidate.evidence.add("another would be as likely");
    }
    const bool open = candidate.evidence.value < likely_evidence;
    uses[candidate.a] = uses[candidate.b] = open ? Use::Open : Use::Settled;
    chosen.push_back(c);
  }
  std::ranges::sort(chosen, {}, [&](std::size_t c) { return candidates[c].a; });
  for (const std::size_t c : chosen) {
    guesses.push_back(guess_from(candidates[c]));
    shared_paths.push_back(weighing.shared_path(candidates[c].a, candidates[c].b, candidates[c].evidence));
  }
  name_takes(guesses, shared_paths);
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
