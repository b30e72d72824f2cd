#include "core/annotation/candidate_grid.hpp"

#include <cmath>
#include <vector>

namespace abrazo {

namespace {

constexpr double cell_s = 0.125;  ///< the labels' own boundaries are no finer

}  // namespace

CandidateLengths candidate_lengths(const LabelledMoves& moves) {
  if (!moves.has_labels) return {};
  std::vector<double> lengths;
  for (const LabelledTake& take : moves.takes)
    for (const LabelledMove& move : take.moves)
      lengths.push_back((move.end - move.begin) / take.channels[0].fps);
  const auto [least, greatest] = std::minmax_element(lengths.begin(), lengths.end());
  return {0.8 * *least, 1.15 * *greatest};
}

CandidateGrid candidate_grid(const MotionChannels& channels, const CandidateLengths& lengths) {
  CandidateGrid grid;
  grid.frames = channels.frames();
  grid.cell = std::max(1, static_cast<int>(std::lround(cell_s * channels.fps)));
  grid.cells = std::max(1, (grid.frames + grid.cell - 1) / grid.cell);
  grid.shortest = std::max(1, static_cast<int>(std::floor(lengths.shortest_s * channels.fps / grid.cell)));
  grid.longest =
      std::max(grid.shortest, static_cast<int>(std::ceil(lengths.longest_s * channels.fps / grid.cell)));
  return grid;
}

double overlap(int begin, int end, int other_begin, int other_end) {
  const double common = std::min(end, other_end) - std::max(begin, other_begin);
  return common <= 0 ? 0 : common / (std::max(end, other_end) - std::min(begin, other_begin));
}

}  // namespace abrazo
