#include "core/session/frames/decision_edits.hpp"

#include <algorithm>
#include <utility>

namespace abrazo {
namespace {

constexpr std::size_t most_single_pairs = 3;

std::string label_of(int pair, const MotionLibrary& library) {
  return std::string(library.label(pair));
}

/// "in and out": a label as it is read.
std::string words_of(std::string label) {
  if (label.empty()) return "without a label";
  std::ranges::replace(label, '_', ' ');
  return label;
}

template <typename Set, typename Value>
void toggle(Set& set, const Value& value) {
  if (set.erase(value) == 0) set.insert(value);
}

template <typename Set, typename Value>
Decisions without(const Decisions& decisions, Set Vetoes::*part, const Value& value) {
  Decisions rest = decisions;
  (rest.vetoes.*part).erase(value);
  return rest;
}

bool exists(int pair, const MotionLibrary& library) {
  return pair >= 0 && pair < library.pair_count();
}

/// A pin is stronger than a veto.
Decisions without_vetoed_pin(Decisions decisions, const MotionLibrary& library) {
  if (decisions.pinned && exists(*decisions.pinned, library) &&
      is_vetoed(decisions, *decisions.pinned, library))
    decisions.pinned.reset();
  return decisions;
}

bool has_label(const MotionLibrary& library, const std::string& label) {
  if (label.empty()) return true;
  for (const LibraryTake& take : library.takes())
    for (const LabelInterval& interval : take.labels)
      if (interval.label == label) return true;
  return false;
}

/// The pair of another library that is the same recorded frame; -1 when it has none.
int matching_pair(const MotionLibrary& from, int pair, const MotionLibrary& to) {
  if (!exists(pair, from)) return -1;
  const PairSource& source = from.source(pair);
  return to.find_pair(from.take_of(pair).name, static_cast<int>(source.frame), source.swapped);
}

}  // namespace

bool is_neutral(const Decisions& decisions) {
  return !decisions.pinned && decisions.vetoes.empty() && !decisions.meant;
}

Decisions with_pin_toggled(Decisions decisions, int pair) {
  if (decisions.pinned == pair) {
    decisions.pinned.reset();
  } else {
    decisions.pinned = pair;
    decisions.vetoes.pairs.erase(pair);
  }
  return decisions;
}

Decisions with_veto_toggled(Decisions decisions, Reach reach, int pair, const MotionLibrary& library) {
  switch (reach) {
    case Reach::Pair:
      toggle(decisions.vetoes.pairs, pair);
      break;
    case Reach::Take:
      toggle(decisions.vetoes.takes, library.take_of(pair).name);
      break;
    case Reach::Label:
      toggle(decisions.vetoes.labels, label_of(pair, library));
      break;
  }
  return without_vetoed_pin(std::move(decisions), library);
}

Decisions with_take_toggled(Decisions decisions, const std::string& take, const MotionLibrary& library) {
  toggle(decisions.vetoes.takes, take);
  return without_vetoed_pin(std::move(decisions), library);
}

bool is_vetoed(const Decisions& decisions, Reach reach, int pair, const MotionLibrary& library) {
  switch (reach) {
    case Reach::Pair:
      return decisions.vetoes.pairs.contains(pair);
    case Reach::Take:
      return decisions.vetoes.takes.contains(library.take_of(pair).name);
    case Reach::Label:
      return decisions.vetoes.labels.contains(label_of(pair, library));
  }
  return false;
}

bool is_vetoed(const Decisions& decisions, int pair, const MotionLibrary& library) {
  return is_vetoed(decisions, Reach::Pair, pair, library) ||
         is_vetoed(decisions, Reach::Take, pair, library) ||
         is_vetoed(decisions, Reach::Label, pair, library);
}

bool is_not_intended(const Decisions& decisions, int pair, const MotionLibrary& library) {
  if (!decisions.meant || !exists(pair, library)) return false;
  const IntendedMove& move = *decisions.meant;
  return (move.label && *move.label != library.label(pair)) ||
         (move.take && *move.take != library.take_of(pair).name);
}

std::string meant_words(const IntendedMove& move) {
  std::string words;
  if (move.label) words = words_of(*move.label);
  if (move.take) words += (words.empty() ? "take " : " of ") + *move.take;
  return words;
}

Decisions carried_over(const Decisions& decisions, const MotionLibrary& from, const MotionLibrary& to) {
  Decisions carried;
  carried.role_control = decisions.role_control;
  const auto there = [&](int pair) { return matching_pair(from, pair, to); };
  if (decisions.pinned && there(*decisions.pinned) >= 0) carried.pinned = there(*decisions.pinned);
  for (const int pair : decisions.vetoes.pairs)
    if (there(pair) >= 0) carried.vetoes.pairs.insert(there(pair));
  for (const std::string& take : decisions.vetoes.takes)
    if (to.find_take(take) >= 0) carried.vetoes.takes.insert(take);
  for (const std::string& label : decisions.vetoes.labels)
    if (has_label(to, label)) carried.vetoes.labels.insert(label);
  const auto& meant = decisions.meant;
  if (meant && (!meant->take || to.find_take(*meant->take) >= 0) &&
      (!meant->label || has_label(to, *meant->label)))
    carried.meant = meant;
  return carried;
}

std::string pair_name(int pair, const MotionLibrary& library) {
  if (!exists(pair, library)) return "pair " + std::to_string(pair);
  return library.take_of(pair).name + " " + std::to_string(library.source(pair).frame);
}

std::vector<Decision> decisions_in_force(const Decisions& decisions, const MotionLibrary& library) {
  std::vector<Decision> found;
  if (decisions.meant) {
    Decisions rest = decisions;
    rest.meant.reset();
    found.push_back({Decision::Kind::Meant, "intended: " + meant_words(*decisions.meant), rest});
  }
  if (decisions.pinned) {
    Decisions rest = decisions;
    rest.pinned.reset();
    found.push_back({Decision::Kind::Pin, pair_name(*decisions.pinned, library), rest});
  }
  for (const std::string& label : decisions.vetoes.labels)
    found.push_back(
        {Decision::Kind::Veto, "all " + words_of(label), without(decisions, &Vetoes::labels, label)});
  for (const std::string& take : decisions.vetoes.takes)
    found.push_back({Decision::Kind::Veto, "take " + take, without(decisions, &Vetoes::takes, take)});
  if (decisions.vetoes.pairs.size() > most_single_pairs) {
    Decisions rest = decisions;
    rest.vetoes.pairs.clear();
    found.push_back({Decision::Kind::Veto, std::to_string(decisions.vetoes.pairs.size()) + " pairs", rest});
  } else {
    for (const int pair : decisions.vetoes.pairs)
      found.push_back(
          {Decision::Kind::Veto, pair_name(pair, library), without(decisions, &Vetoes::pairs, pair)});
  }
  return found;
}

}  // namespace abrazo
