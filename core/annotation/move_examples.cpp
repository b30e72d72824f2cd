#include "core/annotation/move_examples.hpp"

#include <random>
#include <utility>

#include "core/annotation/segment_features.hpp"

namespace abrazo {

namespace {

constexpr double good_overlap = 0.8;   ///< a candidate that overlaps a move this much is it
constexpr double poor_overlap = 0.65;  ///< less is none; values between are not used
constexpr double known_share = 0.8;    ///< of a candidate that is none must be labelled
constexpr double none_per_move = 3;    ///< weight of candidates that are none, for every move
constexpr int none_rows_per_move = 60;

struct Candidate {
  int begin = 0, end = 0;
  int move = -1;  ///< that it is; -1 = none
};
struct Candidates {
  std::vector<Candidate> moves, none;
};

/// The move that a stretch overlaps best; -1 when it overlaps none.
int nearest_move(const std::vector<LabelledMove>& moves, int begin, int end) {
  int nearest = -1;
  double most = 0;
  for (std::size_t m = 0; m < moves.size(); ++m)
    if (const double shared = overlap(begin, end, moves[m].begin, moves[m].end); shared > most)
      most = shared, nearest = static_cast<int>(m);
  return nearest;
}

/// Share of a stretch covered by labels.
double labelled_share(const std::vector<LabelledMove>& moves, int begin, int end) {
  int frames = 0;
  for (const LabelledMove& move : moves)
    frames += std::max(0, std::min(end, move.end) - std::max(begin, move.begin));
  return static_cast<double>(frames) / (end - begin);
}

Candidates candidates_of(const LabelledTake& take, const CandidateGrid& grid, bool has_labels) {
  Candidates found;
  if (has_labels)
    for (std::size_t m = 0; m < take.moves.size(); ++m)
      found.moves.push_back({take.moves[m].begin, take.moves[m].end, static_cast<int>(m)});
  for (int at = 0; at < grid.cells; ++at)
    for (int length = grid.shortest; length <= grid.longest && at + length <= grid.cells; ++length) {
      const int begin = grid.begin(at), end = grid.end(at, length);
      const int nearest = nearest_move(take.moves, begin, end);
      if (nearest < 0) continue;
      const LabelledMove& move = take.moves[static_cast<std::size_t>(nearest)];
      const double shared = overlap(begin, end, move.begin, move.end);
      const bool is_move = has_labels ? shared >= good_overlap : begin >= move.begin && end <= move.end;
      if (is_move)
        found.moves.push_back({begin, end, nearest});
      else if (has_labels && shared < poor_overlap && labelled_share(take.moves, begin, end) >= known_share)
        found.none.push_back({begin, end, -1});
    }
  return found;
}

/// Draws some, each at most once.
void thin(std::vector<Candidate>& candidates, std::size_t wanted, std::mt19937_64& random) {
  wanted = std::min(wanted, candidates.size());
  for (std::size_t i = 0; i < wanted; ++i)
    std::swap(candidates[i], candidates[i + random() % (candidates.size() - i)]);
  candidates.resize(wanted);
}

/// Examples whose number is not known beforehand.
class Collection {
 public:
  Collection(const LabelledMoves& moves, const CandidateLengths& lengths)
      : moves_(moves), lengths_(lengths), times_(moves.labels.size(), 0) {
    for (const LabelledTake& take : moves.takes)
      for (const LabelledMove& move : take.moves) ++times_[static_cast<std::size_t>(move.label)];
  }

  void add_take(const LabelledTake& take) {
    const CandidateGrid grid = candidate_grid(take.channels[0], lengths_);
    Candidates candidates = candidates_of(take, grid, moves_.has_labels);
    thin(candidates.none, take.moves.size() * none_rows_per_move, random_);
    std::vector<int> covered_by(take.moves.size(), 0);
    for (const Candidate& candidate : candidates.moves)
      ++covered_by[static_cast<std::size_t>(candidate.move)];
    const std::array<SegmentFeatures, 2> features = {SegmentFeatures(take.channels[0]),
                                                     SegmentFeatures(take.channels[1])};
    const int none = static_cast<int>(moves_.labels.size());
    for (const Candidate& candidate : candidates.moves) {
      const auto m = static_cast<std::size_t>(candidate.move);
      const LabelledMove& move = take.moves[m];
      const double weight =
          moves_.move_count / (static_cast<double>(moves_.labels.size()) *
                               times_[static_cast<std::size_t>(move.label)] * covered_by[m]);
      const int order = std::max(0, move.active);
      add(features[static_cast<std::size_t>(order)], candidate, move.label, weight,
          first_move_ + candidate.move);
      const bool both = move.active < 0;  // both orders are valid if the active performer is unknown
      add(features[static_cast<std::size_t>(1 - order)], candidate, both ? move.label : none, weight,
          both ? first_move_ + candidate.move : -1);
    }
    const double weight = none_per_move * static_cast<double>(take.moves.size()) /
                          static_cast<double>(std::max<std::size_t>(1, candidates.none.size()));
    for (const Candidate& candidate : candidates.none)
      add(features[random_() % 2], candidate, none, weight, -1);
    first_move_ += static_cast<int>(take.moves.size());
    ++take_;
  }

  ForestExamples examples() && {
    const auto rows = static_cast<Eigen::Index>(examples_.classes.size());
    const Eigen::Index columns = rows == 0 ? 0 : static_cast<Eigen::Index>(values_.size()) / rows;
    examples_.features =
        Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
            values_.data(), rows, columns);
    examples_.class_count = static_cast<int>(moves_.labels.size()) + 1;
    examples_.group_count = take_;
    return std::move(examples_);
  }

 private:
  void add(const SegmentFeatures& features, const Candidate& candidate, int of_class, double weight,
           int origin) {
    const std::size_t row = values_.size();
    values_.resize(row + static_cast<std::size_t>(features.count()));
    features.describe(candidate.begin, candidate.end, values_.data() + row);
    examples_.classes.push_back(of_class);
    examples_.weights.push_back(weight);
    examples_.groups.push_back(take_);
    examples_.origins.push_back(origin);
  }

  const LabelledMoves& moves_;
  const CandidateLengths lengths_;
  std::vector<double> times_;  ///< moves of each label
  std::mt19937_64 random_{7};
  int take_ = 0, first_move_ = 0;
  ForestExamples examples_;
  std::vector<float> values_;  ///< rows one after the other
};

}  // namespace

ForestExamples move_examples(const LabelledMoves& moves, const CandidateLengths& lengths) {
  Collection collection(moves, lengths);
  for (const LabelledTake& take : moves.takes) collection.add_take(take);
  return std::move(collection).examples();
}

}  // namespace abrazo
