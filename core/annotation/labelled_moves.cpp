#include "core/annotation/labelled_moves.hpp"

#include <algorithm>
#include <cmath>

namespace abrazo {

namespace {

constexpr int fewest_pieces = 4;      ///< of all takes together
constexpr double longest_move_s = 8;  ///< a longer stretch is several

int active_at(const std::vector<RoleInterval>& roles, int frame) {
  for (const RoleInterval& role : roles)
    if (frame >= role.start && frame < role.end)
      return role.active == ActivePerformer::Unknown ? -1 : role.active == ActivePerformer::A ? 0 : 1;
  return -1;
}

/// Position of a frame of the take among the frames that are looked at.
int position(const CoupleMotion& motion, int frame) {
  return static_cast<int>(std::lower_bound(motion.frames.begin(), motion.frames.end(), frame) -
                          motion.frames.begin());
}

int index_of(std::vector<std::string>& labels, const std::string& label) {
  const auto found = std::find(labels.begin(), labels.end(), label);
  if (found != labels.end()) return static_cast<int>(found - labels.begin());
  labels.push_back(label);
  return static_cast<int>(labels.size()) - 1;
}

void add_move(LabelledTake& take, const CoupleMotion& motion, LabelledMove move) {
  const double seconds = (move.end - move.begin) / motion.fps;
  const int parts = std::max(1, static_cast<int>(std::ceil(seconds / longest_move_s)));
  const int begin = move.begin, frames = move.end - move.begin;
  for (int part = 0; part < parts; ++part) {
    move.begin = begin + frames * part / parts;
    move.end = begin + frames * (part + 1) / parts;
    if (move.end > move.begin) take.moves.push_back(move);
  }
}

MotionChannels piece_of(const MotionChannels& channels, int begin, int end) {
  const auto cut = [&](const std::vector<double>& turns) {
    return std::vector<double>(turns.begin() + begin, turns.begin() + end);
  };
  return {channels.fps, channels.values.middleRows(begin, end - begin), cut(channels.n_x), cut(channels.n_y),
          cut(channels.orb)};
}

/// A take in about `pieces` pieces, each beginning with a move.
void add_pieces(std::vector<LabelledTake>& to, const LabelledTake& take, int pieces) {
  const std::size_t moves = take.moves.size(), parts = std::min(moves, static_cast<std::size_t>(pieces));
  for (std::size_t part = 0; part < parts; ++part) {
    const auto from = static_cast<std::ptrdiff_t>(moves * part / parts),
               until = static_cast<std::ptrdiff_t>(moves * (part + 1) / parts);
    LabelledTake piece{take.take, {}, {take.moves.begin() + from, take.moves.begin() + until}};
    const int begin = part == 0 ? 0 : piece.moves.front().begin;
    const int end = part + 1 == parts ? take.channels[0].frames() : piece.moves.back().end;
    for (std::size_t order = 0; order < 2; ++order)
      piece.channels[order] = piece_of(take.channels[order], begin, end);
    for (LabelledMove& move : piece.moves) move.begin -= begin, move.end -= begin;
    to.push_back(std::move(piece));
  }
}

}  // namespace

std::array<MotionChannels, 2> channels_of(const CoupleMotion& motion) {
  const CoupleGeometry geometry = couple_geometry(motion);
  return {motion_channels(motion, geometry, false), motion_channels(motion, geometry, true)};
}

LabelledMoves labelled_moves(const MotionLibrary& library, int without) {
  LabelledMoves found;
  const auto& takes = library.takes();
  for (std::size_t t = 0; t < takes.size(); ++t) {
    if (static_cast<int>(t) == without) continue;
    found.has_labels = found.has_labels || !takes[t].labels.empty();
    for (const RoleInterval& role : takes[t].roles)
      found.has_roles = found.has_roles || role.active != ActivePerformer::Unknown;
  }
  if (!found.has_labels && !found.has_roles) return found;
  for (std::size_t t = 0; t < takes.size(); ++t) {
    const LibraryTake& of = takes[t];
    if (static_cast<int>(t) == without || (found.has_labels ? of.labels.empty() : of.roles.empty())) continue;
    const CoupleMotion motion = couple_motion(library, static_cast<int>(t), suggestion_rate_hz);
    LabelledTake take{static_cast<int>(t), channels_of(motion), {}};
    if (found.has_labels)
      for (const LabelInterval& label : of.labels)
        add_move(take, motion,
                 {position(motion, label.start), position(motion, label.end),
                  index_of(found.labels, label.label), active_at(of.roles, (label.start + label.end) / 2)});
    else
      for (const RoleInterval& role : of.roles)
        if (role.active != ActivePerformer::Unknown)
          add_move(take, motion,
                   {position(motion, role.start), position(motion, role.end), index_of(found.labels, ""),
                    active_at(of.roles, role.start)});
    if (!take.moves.empty()) found.takes.push_back(std::move(take));
  }
  const int takes_found = static_cast<int>(found.takes.size());
  if (takes_found > 0 && takes_found < fewest_pieces) {
    std::vector<LabelledTake> pieces;
    for (const LabelledTake& take : found.takes)
      add_pieces(pieces, take, (fewest_pieces + takes_found - 1) / takes_found);
    found.takes = std::move(pieces);
  }
  for (const LabelledTake& take : found.takes) found.move_count += static_cast<int>(take.moves.size());
  return found;
}

}  // namespace abrazo
