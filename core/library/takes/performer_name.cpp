#include "core/library/takes/performer_name.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <utility>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

/// Who is active, and what the other is then called.
constexpr std::array<std::pair<std::string_view, std::string_view>, 18> opposite_roles = {
    {{"leader", "follower"},
     {"lead", "follow"},
     {"leading", "following"},
     {"leader", "partner"},
     {"man", "woman"},
     {"male", "female"},
     {"boy", "girl"},
     {"he", "she"},
     {"active", "passive"},
     {"actor", "reactor"},
     {"actor", "partner"},
     {"attacker", "defender"},
     {"attack", "defence"},
     {"attack", "defense"},
     {"attacker", "victim"},
     {"user", "partner"},
     {"me", "partner"},
     {"self", "other"}}};

/// Words before the number of a performer, and before that of a recording.
constexpr std::array<std::string_view, 22> performer_words = {
    "p",      "c",         "s",       "person", "performer", "player", "subject", "subj",
    "sub",    "character", "char",    "actor",  "dancer",    "body",   "human",   "skeleton",
    "people", "fighter",   "partner", "user",   "man",       "sbj"};
constexpr std::array<std::string_view, 21> recording_words = {
    "take",  "t",       "trial",  "seq", "sequence", "clip", "rec",   "recording", "run",    "song", "part",
    "scene", "session", "motion", "day", "rep",      "shot", "round", "pair",      "couple", "duet"};

enum class Kind { Digit, Letter, Other };

/// Bytes beyond ASCII are letters: names are UTF-8.
Kind kind_of(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (std::isdigit(byte) != 0) return Kind::Digit;
  return std::isalpha(byte) != 0 || byte >= 128 ? Kind::Letter : Kind::Other;
}

bool is_number(std::string_view part) {
  return std::all_of(part.begin(), part.end(), [](char c) { return kind_of(c) == Kind::Digit; });
}

/// +1 when `first` is the active one of two opposite roles, -1 when `second` is, 0 when they are not such.
int role_order(std::string_view first, std::string_view second) {
  for (const auto& [active, passive] : opposite_roles) {
    if (first == active && second == passive) return 1;
    if (first == passive && second == active) return -1;
  }
  return 0;
}

bool is_one_of(std::span<const std::string_view> words, std::string_view word) {
  return std::ranges::find(words, word) != words.end();
}

/// Of parts at one place, by themselves and by the word before them.
NameContrast contrast_of(std::span<const NamePart> first, std::span<const NamePart> second, std::size_t i) {
  const std::string_view one = first[i].text, other = second[i].text;
  if (role_order(one, other) != 0) return NameContrast::Roles;
  if (is_number(one) != is_number(other)) return NameContrast::None;
  if (is_number(one)) {
    const std::string_view before = i > 0 ? std::string_view(first[i - 1].text) : std::string_view();
    if (is_one_of(recording_words, before)) return NameContrast::None;
    return is_one_of(performer_words, before) ? NameContrast::Performers : NameContrast::Numbers;
  }
  const bool letters = one.size() == 1 && other.size() == 1;
  return letters ? NameContrast::Letters : NameContrast::Words;
}

/// "take1" and "take1_partner", "take1 2", "take1b".
std::optional<NameDifference> extension_of(std::span<const NamePart> shorter,
                                           std::span<const NamePart> longer) {
  for (std::size_t i = 0; i < shorter.size(); ++i)
    if (shorter[i].text != longer[i].text) return std::nullopt;
  const std::string& extra = longer.back().text;
  static constexpr std::array<std::string_view, 9> seconds = {
      "b", "2", "partner", "follower", "follow", "passive", "defender", "reactor", "woman"};
  if (std::find(seconds.begin(), seconds.end(), extra) == seconds.end()) return std::nullopt;
  NameDifference difference;
  difference.contrast = extra.size() == 1 ? NameContrast::Words : NameContrast::Roles;
  difference.part = shorter.size();
  difference.second = extra;
  difference.one_more_part = true;
  return difference;
}

}  // namespace

std::vector<NamePart> parts_of_name(std::string_view name) {
  std::vector<NamePart> parts;
  for (std::size_t i = 0; i < name.size(); ++i) {
    const Kind kind = kind_of(name[i]);
    if (kind == Kind::Other) continue;
    const bool capital = std::isupper(static_cast<unsigned char>(name[i])) != 0;
    const bool after_small = i > 0 && std::islower(static_cast<unsigned char>(name[i - 1])) != 0;
    const bool same_part =
        i > 0 && !parts.empty() && kind_of(name[i - 1]) == kind && !(capital && after_small);
    if (!same_part) parts.push_back({{}, i, 0});
    ++parts.back().size;
  }
  for (NamePart& part : parts) part.text = lower_case(name.substr(part.begin, part.size));
  return parts;
}

std::optional<NameDifference> difference_of_names(std::span<const NamePart> a, std::span<const NamePart> b) {
  if (b.size() == a.size() + 1 && !a.empty()) return extension_of(a, b);
  if (a.size() != b.size()) return std::nullopt;
  std::optional<NameDifference> found;
  int differing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].text == b[i].text) continue;
    if (++differing > 2) return std::nullopt;
    NameDifference here{contrast_of(a, b, i), i, a[i].text, b[i].text};
    here.first_is_active = role_order(a[i].text, b[i].text) >= 0;
    // With a role there may also be the subject's number or letter: s60_leader, s61_follower.
    if (!found || here.contrast > found->contrast) found = here;
  }
  if (differing == 0 || found->contrast == NameContrast::None) return std::nullopt;
  found->also_numbers = differing == 2;
  if (found->also_numbers && found->contrast != NameContrast::Roles) return std::nullopt;
  return found;
}

std::string shared_name(std::string_view first, const NameDifference& difference) {
  if (difference.one_more_part) return std::string(first);
  const std::vector<NamePart> parts = parts_of_name(first);
  const NamePart& cut = parts[difference.part];
  std::size_t begin = cut.begin;
  if (difference.contrast == NameContrast::Performers) begin = parts[difference.part - 1].begin;
  const auto is_joint = [](char c) { return kind_of(c) == Kind::Other; };
  std::string_view before = first.substr(0, begin), after = first.substr(cut.begin + cut.size);
  // One of the separators around the removed part stays, that of folders if there is one.
  if (before.empty() || before.back() == '/')
    while (!after.empty() && is_joint(after.front())) after.remove_prefix(1);
  while (!before.empty() && is_joint(before.back()) && (after.empty() || is_joint(after.front())))
    before.remove_suffix(1);
  return std::string(before) + std::string(after);
}

}  // namespace abrazo
