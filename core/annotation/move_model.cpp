#include "core/annotation/move_model.hpp"

#include <cmath>

#include "core/annotation/move_examples.hpp"
#include "core/annotation/segment_features.hpp"

namespace abrazo {

namespace {

constexpr double right_overlap = 0.5;  ///< a suggestion that overlaps a move of its label this much is right
constexpr double temperature = 2;      ///< overlapping candidates are redundant
constexpr double least_share = 0.01;   ///< no forest is surer than that
constexpr int shown_neighbours = 9;
constexpr std::size_t fewest_takes_to_try = 3;

double log_odds(double share, double share_of_none) {
  return std::log((share + least_share) / (share_of_none + least_share));
}

}  // namespace

double MoveModel::Trials::goodness() const {
  return (frames > 0 ? agreed_frames / frames : 0) +
         (proposed + truths > 0 ? 2.0 * right / (proposed + truths) : 0);
}

void MoveModel::Trials::add(const ProposedMove& move, const LabelledTake& take) {
  bool is_right = false;
  double common_frames = 0, role_frames = 0, role_agreed = 0;
  for (const LabelledMove& truth : take.moves) {
    const double common = std::min(move.end, truth.end) - std::max(move.begin, truth.begin);
    if (common <= 0) continue;
    common_frames += common;
    agreed_frames += truth.label == move.label ? common : 0;
    role_frames += truth.active >= 0 ? common : 0;
    role_agreed += truth.active == move.active ? common : 0;
    is_right = is_right || (truth.label == move.label &&
                            overlap(move.begin, move.end, truth.begin, truth.end) >= right_overlap);
  }
  if (common_frames == 0) return;  // it has no label
  frames += common_frames;
  ++proposed;
  right += is_right ? 1 : 0;
  moves.push_back({move.move_evidence, is_right});
  if (role_frames > 0) roles.push_back({move.role_evidence, 2 * role_agreed > role_frames});
}

Result<MoveModel> MoveModel::learn(const LabelledMoves& moves, const Progress& progress) {
  MoveModel model(moves);
  model.lengths_ = candidate_lengths(moves);
  model.order_ = label_order(moves, model.role_count());
  auto forest = DecisionForest::learn(move_examples(moves, model.lengths_), {}, part(progress, 0, 0.7));
  if (!forest) return forest.error();
  model.forest_ = std::move(*forest);
  if (const Status tried = model.try_out(part(progress, 0.7, 1)); !tried) return tried.error();
  return model;
}

TilingScores MoveModel::evidence(const std::array<MotionChannels, 2>& channels,
                                 std::optional<int> unseen) const {
  const CandidateGrid grid = candidate_grid(channels[0], lengths_);
  const int roles = role_count();
  const auto none = moves_->labels.size();
  TilingScores scores(grid.cells, grid.longest, order_.states);
  for (int role = 0; role < roles; ++role) {
    const SegmentFeatures features(channels[static_cast<std::size_t>(role)]);
    std::vector<float> row(static_cast<std::size_t>(features.count())), shares(none + 1);
    for (int at = 0; at < grid.cells; ++at)
      for (int length = 1; length <= scores.longest() && at + length <= grid.cells; ++length) {
        // Shorter than any move is only what the end of the take cuts off.
        if (length < grid.shortest && at + length < grid.cells) continue;
        features.describe(grid.begin(at), grid.end(at, length), row.data());
        forest_->shares(row.data(), unseen, shares.data());
        for (std::size_t label = 0; label < none; ++label)
          scores.segment(at, length, static_cast<int>(label) * roles + role) =
              log_odds(static_cast<double>(shares[label]), static_cast<double>(shares[none]));
      }
  }
  return scores;
}

void MoveModel::weigh(TilingScores& scores, const Weights& weights) const {
  for (int state = 0; state < order_.states; ++state) {
    const auto s = static_cast<std::size_t>(state);
    scores.first[s] = weights.follows * order_.first[s];
    scores.last[s] = weights.follows * order_.last[s];
    for (int next = 0; next < order_.states; ++next)
      scores.follows(state, next) =
          weights.segment +
          weights.follows *
              order_.follows[s * static_cast<std::size_t>(order_.states) + static_cast<std::size_t>(next)];
  }
}

std::vector<ProposedMove> MoveModel::read(const TilingScores& scores, const MotionChannels& channels) const {
  const CandidateGrid grid = candidate_grid(channels, lengths_);
  const int roles = role_count();
  const std::vector<double> probability = state_probabilities(scores, temperature);
  std::vector<ProposedMove> moves;
  for (const TilingSegment& segment : best_tiling(scores)) {
    const int length = segment.end - segment.begin;
    ProposedMove move;
    move.begin = grid.begin(segment.begin);
    move.end = grid.end(segment.begin, length);
    move.label = segment.state / roles;
    move.active = segment.state % roles;
    for (int cell = segment.begin; cell < segment.end; ++cell)
      for (int state = 0; state < scores.states(); ++state) {
        const double share = probability[static_cast<std::size_t>(cell * scores.states() + state)] / length;
        if (state / roles == move.label) move.move_evidence.probability += share;
        if (state % roles == move.active) move.role_evidence.probability += share;
      }
    const double strength = scores.segment(segment.begin, length, segment.state);
    move.move_evidence.strength = strength;
    if (roles == 2)
      move.role_evidence.strength =
          strength - scores.segment(segment.begin, length, move.label * roles + 1 - move.active);
    moves.push_back(std::move(move));
  }
  return moves;
}

Status MoveModel::try_out(const Progress& progress) {
  const auto& takes = moves_->takes;
  if (takes.size() < fewest_takes_to_try) return Done{};
  std::vector<TilingScores> scores;
  for (std::size_t take = 0; take < takes.size(); ++take) {
    if (!report(progress, static_cast<double>(take) / static_cast<double>(takes.size()),
                "trying it on the labelled takes"))
      return Error{"cancelled", ""};
    scores.push_back(evidence(takes[take].channels, static_cast<int>(take)));
  }
  double best = -1;
  for (const double follows : {0.5, 1.0})
    for (const double segment : {-2.0, -1.0, 0.0, 1.0, 2.0, 3.0}) {
      Trials trials;
      for (std::size_t take = 0; take < takes.size(); ++take) {
        weigh(scores[take], {segment, follows});
        for (const ProposedMove& move : read(scores[take], takes[take].channels[0]))
          trials.add(move, takes[take]);
        trials.truths += static_cast<int>(takes[take].moves.size());
      }
      if (trials.goodness() <= best) continue;
      best = trials.goodness();
      weights_ = {segment, follows};
      move_scale_ = ConfidenceScale::fit(trials.moves);
      role_scale_ = ConfidenceScale::fit(trials.roles);
    }
  return Done{};
}

std::vector<ProposedMove> MoveModel::propose(const std::array<MotionChannels, 2>& channels) const {
  if (channels[0].frames() == 0) return {};
  TilingScores scores = evidence(channels, std::nullopt);
  weigh(scores, weights_);
  std::vector<ProposedMove> moves = read(scores, channels[0]);
  const std::array<SegmentFeatures, 2> features = {SegmentFeatures(channels[0]),
                                                   SegmentFeatures(channels[1])};
  std::vector<float> row(static_cast<std::size_t>(features[0].count()));
  for (ProposedMove& move : moves) {
    move.confidence = move_scale_(move.move_evidence);
    move.role_confidence = role_scale_(move.role_evidence);
    features[static_cast<std::size_t>(move.active)].describe(move.begin, move.end, row.data());
    move.neighbours = forest_->neighbours(row.data(), shown_neighbours);
  }
  return moves;
}

}  // namespace abrazo
