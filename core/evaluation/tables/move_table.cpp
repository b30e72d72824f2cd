#include "core/evaluation/tables/move_table.hpp"

#include <algorithm>
#include <set>
#include <string_view>

namespace abrazo {

namespace {

/// A label with who is active, where that is part of the move and known.
std::string named(std::string_view label, bool both_roles, ActivePerformer active, ActivePerformer user) {
  std::string name(label);
  if (both_roles && active != ActivePerformer::Unknown && is_move(label))
    name += active == user ? " (user)" : " (partner)";
  return name;
}

/// The move that each pair of the library shows, for a user in the given role.
std::vector<std::string> library_moves(const MotionLibrary& library, UserRole role, bool both_roles) {
  std::vector<std::string> moves;
  for (int pair = 0; pair < library.pair_count(); ++pair) {
    const PairSource& source = library.source(pair);
    const ActivePerformer first = source.swapped ? ActivePerformer::B : ActivePerformer::A;
    const ActivePerformer user = role == UserRole::Active ? first : other(first);
    moves.push_back(named(library.label(pair), both_roles, source.annotated, user));
  }
  return moves;
}

/// Steps of one take whose frames lie in [start, end).
struct Steps {
  std::size_t first = 0, last = 0;
};
Steps steps_of(const SynthesisedTake& take, const LabelInterval& label) {
  const auto begin = take.frames.begin();
  return {static_cast<std::size_t>(std::lower_bound(begin, take.frames.end(), label.start) - begin),
          static_cast<std::size_t>(std::lower_bound(begin, take.frames.end(), label.end) - begin)};
}

/// One move as it came out.
struct CountedMove {
  std::string take, own, lenient;
  std::map<std::string, int> steps;  ///< by the move of their source

  /// Most steps; of equals the own one, else the first by name.
  std::string majority() const {
    std::string best;
    int most = 0;
    for (const auto& [move, count] : steps)
      if (count > most || (count == most && move == own)) best = move, most = count;
    return best;
  }
};

std::vector<CountedMove> moves_of(const SynthesisedTake& take, const std::vector<std::string>& sources,
                                  bool both_roles) {
  std::vector<CountedMove> moves;
  for (const LabelInterval& label : take.take->labels) {
    if (!is_move(label.label)) continue;
    const auto [first, last] = steps_of(take, label);
    const ActivePerformer active = active_at(*take.take, (label.start + label.end) / 2);
    CountedMove move{.take = take.take->name,
                     .own = named(label.label, both_roles, active, take.user),
                     .lenient = named(alternative_label(label), both_roles, active, take.user),
                     .steps = {}};
    for (std::size_t step = first; step < last; ++step)
      ++move.steps[sources[static_cast<std::size_t>(take.pairs[step])]];
    moves.push_back(std::move(move));
  }
  return moves;
}

void add(bool successful, bool lenient, MoveCount& count) {
  ++count.total;
  count.successful += successful;
  count.lenient += successful || lenient;
}

std::string most_frequent_move(const std::vector<std::string>& sources) {
  std::map<std::string, int> counts;
  for (const std::string& move : sources)
    if (is_move(move)) ++counts[move];
  const auto most = std::max_element(counts.begin(), counts.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? std::string() : most->first;
}

/// Rows and columns of the confusion matrices: moves first, then what is none.
std::vector<std::string> all_labels(const std::vector<CountedMove>& moves) {
  std::set<std::string> names;
  for (const CountedMove& move : moves) {
    names.insert(move.own);
    for (const auto& [source, count] : move.steps) names.insert(source);
  }
  std::vector<std::string> labels(names.begin(), names.end());
  std::stable_partition(labels.begin(), labels.end(), [](const std::string& l) { return is_move(l); });
  return labels;
}

void fill_matrices(const std::vector<CountedMove>& moves, MoveTable& table) {
  table.labels = all_labels(moves);
  const auto index = [&](const std::string& label) {
    return static_cast<std::size_t>(std::find(table.labels.begin(), table.labels.end(), label) -
                                    table.labels.begin());
  };
  table.confusion.assign(table.labels.size(), std::vector<int>(table.labels.size(), 0));
  table.steps = table.confusion;
  for (const CountedMove& move : moves) {
    if (move.steps.empty()) continue;
    ++table.confusion[index(move.own)][index(move.majority())];
    for (const auto& [source, count] : move.steps) table.steps[index(move.own)][index(source)] += count;
  }
}

}  // namespace

bool is_move(std::string_view label) {
  return !label.empty() && label != "other" && label != "guard";
}

std::string alternative_label(const LabelInterval& label) {
  const std::size_t at = label.detail.find("alt=");
  if (at == std::string::npos) return {};
  const std::string rest = label.detail.substr(at + 4);
  return rest.substr(0, rest.find_first_of(" ;,)"));
}

MoveTable count_moves(std::span<const SynthesisedTake> takes, const MotionLibrary& library, bool both_roles) {
  MoveTable table;
  if (takes.empty()) return table;
  const std::vector<std::string> sources = library_moves(library, takes.front().user_role, both_roles);
  const std::string frequent = most_frequent_move(sources);
  std::vector<CountedMove> moves;
  for (const SynthesisedTake& take : takes)
    for (CountedMove& move : moves_of(take, sources, both_roles)) moves.push_back(std::move(move));

  int steps = 0, right_steps = 0, chance = 0;
  for (const CountedMove& move : moves) {
    const std::string majority = move.majority();
    const bool successful = majority == move.own, lenient = !majority.empty() && majority == move.lenient;
    for (MoveCount* count : {&table.all, &table.per_take[move.take], &table.per_label[move.own]})
      add(successful, lenient, *count);
    chance += move.own == frequent;
    for (const auto& [source, count] : move.steps) {
      steps += count;
      if (source == move.own) right_steps += count;
    }
  }
  if (steps > 0) table.step_accuracy = static_cast<double>(right_steps) / steps;
  if (!moves.empty()) table.by_chance = static_cast<double>(chance) / static_cast<double>(moves.size());
  fill_matrices(moves, table);
  return table;
}

}  // namespace abrazo
