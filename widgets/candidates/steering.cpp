#include "widgets/candidates/steering.hpp"

#include <algorithm>

namespace abrazo::widgets {
namespace {

constexpr std::size_t most_single_pairs = 3;

std::string label_of(int pair, const MotionLibrary& library) {
  return std::string(library.label(pair));
}

template <typename Set, typename Value>
void toggle(Set& set, const Value& value) {
  if (set.erase(value) == 0) set.insert(value);
}

template <typename Set, typename Value>
Steering without(const Steering& steering, Set Vetoes::*part, const Value& value) {
  Steering rest = steering;
  (rest.vetoes.*part).erase(value);
  return rest;
}

bool exists(int pair, const MotionLibrary& library) {
  return pair >= 0 && pair < library.pair_count();
}

}  // namespace

Steering with_pin_toggled(Steering steering, int pair) {
  if (steering.pinned == pair) {
    steering.pinned.reset();
  } else {
    steering.pinned = pair;
    steering.vetoes.pairs.erase(pair);
  }
  return steering;
}

Steering with_veto_toggled(Steering steering, Reach reach, int pair, const MotionLibrary& library) {
  switch (reach) {
    case Reach::Pair:
      toggle(steering.vetoes.pairs, pair);
      break;
    case Reach::Take:
      toggle(steering.vetoes.takes, library.take_of(pair).name);
      break;
    case Reach::Label:
      toggle(steering.vetoes.labels, label_of(pair, library));
      break;
  }
  if (steering.pinned && exists(*steering.pinned, library) && is_vetoed(steering, *steering.pinned, library))
    steering.pinned.reset();
  return steering;
}

bool is_vetoed(const Steering& steering, Reach reach, int pair, const MotionLibrary& library) {
  switch (reach) {
    case Reach::Pair:
      return steering.vetoes.pairs.contains(pair);
    case Reach::Take:
      return steering.vetoes.takes.contains(library.take_of(pair).name);
    case Reach::Label:
      return steering.vetoes.labels.contains(label_of(pair, library));
  }
  return false;
}

bool is_vetoed(const Steering& steering, int pair, const MotionLibrary& library) {
  return is_vetoed(steering, Reach::Pair, pair, library) || is_vetoed(steering, Reach::Take, pair, library) ||
         is_vetoed(steering, Reach::Label, pair, library);
}

bool is_not_meant(const Steering& steering, int pair, const MotionLibrary& library) {
  if (!steering.meant || !exists(pair, library)) return false;
  const MeantMove& move = *steering.meant;
  return (move.label && *move.label != library.label(pair)) ||
         (move.take && *move.take != library.take_of(pair).name);
}

std::string meant_words(const MeantMove& move) {
  std::string words;
  if (move.label) words = move.label->empty() ? "without a label" : *move.label;
  std::replace(words.begin(), words.end(), '_', ' ');
  if (move.take) words += (words.empty() ? "take " : " of ") + *move.take;
  return words;
}

std::string pair_name(int pair, const MotionLibrary& library) {
  if (!exists(pair, library)) return "pair " + std::to_string(pair);
  return library.take_of(pair).name + " " + std::to_string(library.source(pair).frame);
}

std::vector<Decision> decisions_in_force(const Steering& steering, const MotionLibrary& library) {
  std::vector<Decision> found;
  if (steering.meant) {
    Steering rest = steering;
    rest.meant.reset();
    found.push_back({Decision::Kind::Meant, "intended: " + meant_words(*steering.meant), rest});
  }
  if (steering.pinned) {
    Steering rest = steering;
    rest.pinned.reset();
    found.push_back({Decision::Kind::Pin, pair_name(*steering.pinned, library), rest});
  }
  for (const std::string& label : steering.vetoes.labels)
    found.push_back({Decision::Kind::Veto, label.empty() ? "all without a label" : "all " + label,
                     without(steering, &Vetoes::labels, label)});
  for (const std::string& take : steering.vetoes.takes)
    found.push_back({Decision::Kind::Veto, "take " + take, without(steering, &Vetoes::takes, take)});
  if (steering.vetoes.pairs.size() > most_single_pairs) {
    Steering rest = steering;
    rest.vetoes.pairs.clear();
    found.push_back({Decision::Kind::Veto, std::to_string(steering.vetoes.pairs.size()) + " pairs", rest});
  } else {
    for (const int pair : steering.vetoes.pairs)
      found.push_back(
          {Decision::Kind::Veto, pair_name(pair, library), without(steering, &Vetoes::pairs, pair)});
  }
  return found;
}

}  // namespace abrazo::widgets
