#include "core/motion/joints/marker_naming.hpp"

#include <algorithm>

#include "core/motion/joints/joint_guess.hpp"
#include "core/motion/joints/marker_places.hpp"
#include "core/motion/joints/marker_set.hpp"

namespace abrazo {
namespace {

/// Below it a guess is more often wrong than right.
constexpr double likely_marker = 0.3;

bool is_guessed(const MarkerNaming::Row& row) {
  return row.by == MarkerNaming::By::Guess || row.by == MarkerNaming::By::Proposal;
}

}  // namespace

MarkerNaming::MarkerNaming(std::vector<std::string> points)
    : points_(std::move(points)), rows_(points_.size()) {}

void MarkerNaming::propose(const MarkerGuess& guess) {
  for (Row& row : rows_)
    if (is_guessed(row)) row = {};
  for (const MarkerGuess::Marker& marker : guess.markers) {
    Row& row = rows_.at(static_cast<std::size_t>(marker.point));
    const bool is_taken = std::ranges::any_of(rows_, [&](const Row& other) {
      return other.by == By::Person && other.place == marker.place && other.side == marker.side;
    });
    if (row.by == By::Person || is_taken) continue;
    row = {marker.place, marker.side, marker.confidence,
           marker.confidence >= sure_enough_of_marker ? By::Guess : By::Proposal};
  }
}

bool MarkerNaming::accept(int point) {
  Row& row = rows_.at(static_cast<std::size_t>(point));
  if (!is_guessed(row)) return false;
  row.by = By::Person;
  return true;
}

Status MarkerNaming::say(int point, std::string_view place) {
  Row& row = rows_.at(static_cast<std::size_t>(point));
  if (place.empty()) {
    row = {};
    return Done{};
  }
  const auto spot = marker_spot(place);
  if (!spot)
    return Error{
        "there is no place '" + std::string(place) + "' for a marker; expected one of " + all_marker_places(),
        points_.at(static_cast<std::size_t>(point))};
  for (std::size_t p = 0; p < rows_.size(); ++p) {
    Row& other = rows_[p];
    if (&other == &row || other.place != spot->first || other.side != spot->second) continue;
    if (other.by == By::Person)
      return Error{"the " + std::string(place) + " is already " + points_[p] + "; take it away there first",
                   points_.at(static_cast<std::size_t>(point))};
    other = {};
  }
  row = {spot->first, spot->second, 0, By::Person};
  return Done{};
}

Result<std::size_t> MarkerNaming::read(const MarkerModel& model) {
  const MarkerSet set(model, points_);
  std::vector<Row> rows(rows_.size());
  std::size_t found = 0;
  for (std::size_t place = 0; place < marker_place_count; ++place)
    for (const std::size_t side : {0U, 1U}) {
      const int point = set.of(static_cast<MarkerPlace>(place), side);
      if (point < 0 || rows[static_cast<std::size_t>(point)].by == By::Person) continue;
      rows[static_cast<std::size_t>(point)] = {static_cast<MarkerPlace>(place), side, 0, By::Person};
      ++found;
    }
  if (found == 0)
    return Error{"names none of the " + std::to_string(points_.size()) +
                     " points of this file; expected a marker model with names such as '" +
                     (points_.empty() ? "" : points_.front()) + "'",
                 model.name};
  rows_ = std::move(rows);
  return found;
}

std::string MarkerNaming::place_of(int point) const {
  const Row& row = rows_.at(static_cast<std::size_t>(point));
  return row.by == By::Nothing ? std::string() : name_of_place(row.place, row.side);
}

std::string MarkerNaming::belief_in(int point) const {
  const Row& row = rows_.at(static_cast<std::size_t>(point));
  switch (row.by) {
    case By::Nothing:
      return "";
    case By::Person:
      return "said";
    case By::Guess:
      return "sure";
    case By::Proposal:
      return row.confidence >= likely_marker ? "likely" : "doubtful";
  }
  return "";
}

std::string MarkerNaming::counted() const {
  const auto said = std::ranges::count(rows_, By::Person, &Row::by);
  std::string words = std::to_string(std::ranges::count_if(rows_, is_guessed)) + " of " +
                      std::to_string(rows_.size()) + " markers guessed, " +
                      std::to_string(std::ranges::count(rows_, By::Guess, &Row::by)) + " sure";
  if (said > 0) words += "; " + std::to_string(said) + " said";
  return words;
}

MarkerModel MarkerNaming::model(const std::string& name) const {
  MarkerModel model;
  model.name = name;
  for (std::size_t p = 0; p < rows_.size(); ++p)
    if (rows_[p].by == By::Guess || rows_[p].by == By::Person)
      model.names[static_cast<std::size_t>(rows_[p].place)][rows_[p].side] = {points_[p]};
  return model;
}

bool names_say_nothing(const NamedMotion& motion) {
  constexpr std::size_t fewest_markers_to_guess = 12;
  if (motion.points.size() < fewest_markers_to_guess || motion.frames.empty()) return false;
  if (std::ranges::any_of(motion.parents, [](int parent) { return parent >= 0; })) return false;
  if (nearest_marker_model(motion.points).found > 0) return false;
  const JointGuess joints = guess_joints(motion, 0);
  return std::ranges::find(joints.by, JointGuess::By::Name) == joints.by.end();
}

}  // namespace abrazo
