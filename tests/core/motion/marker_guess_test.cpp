// Markers whose names say nothing, found by their places on a moving body.
#include "core/motion/joints/marker_guess.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <random>

#include "tests/core/motion/marker_body.hpp"

namespace abrazo::marker_guess_test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The markers of a body in another order, called M1, M2, ...
struct Nameless {
  NamedMotion markers;
  std::map<int, std::string> name_of;  ///< what each was called
};

Nameless without_names(const NamedMotion& named) {
  std::vector<Eigen::Index> order(named.points.size());
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  Nameless found;
  found.markers = named;
  for (std::size_t p = 0; p < order.size(); ++p) {
    found.markers.points[p] = "M" + std::to_string(p + 1);
    found.name_of[static_cast<int>(p)] = named.points[static_cast<std::size_t>(order[p])];
    for (std::size_t f = 0; f < named.frames.size(); ++f)
      found.markers.frames[f].row(static_cast<Eigen::Index>(p)) = named.frames[f].row(order[p]);
  }
  return found;
}

const MarkerModel& plug_in_gait() {
  return builtin_marker_models().front();
}

bool is_right(const MarkerGuess::Marker& marker, const std::string& name) {
  const auto& names = plug_in_gait().names[static_cast<std::size_t>(marker.place)][marker.side];
  return std::ranges::find(names, name) != names.end();
}

struct Score {
  int right = 0, sure = 0, sure_and_wrong = 0;
  double share = 0;
};

Score score_of(const Nameless& nameless) {
  const auto guess = guess_markers(nameless.markers);
  EXPECT_TRUE(guess) << guess.error().text();
  Score score;
  if (!guess) return score;
  for (const MarkerGuess::Marker& marker : guess->markers) {
    const bool right = is_right(marker, nameless.name_of.at(marker.point));
    score.right += right ? 1 : 0;
    if (marker.confidence < sure_enough_of_marker) continue;
    ++score.sure;
    score.sure_and_wrong += right ? 0 : 1;
  }
  score.share = score.right / static_cast<double>(nameless.markers.points.size());
  return score;
}

NamedMotion changed(NamedMotion markers, const Eigen::Matrix3d& by) {
  for (Positions& frame : markers.frames) frame = (frame * by.transpose()).eval();
  return markers;
}

TEST(MarkerGuess, FindsTheMarkersOfAShuffledBody) {
  const Score score = score_of(without_names(test::marked_body(60, 0.15).markers));
  EXPECT_GE(score.share, 0.85);
  EXPECT_GE(score.sure, 15);
  EXPECT_EQ(score.sure_and_wrong, 0);
}

TEST(MarkerGuess, NeedsNoUnitAndNoAxes) {
  NamedMotion markers = test::marked_body(60, 0.15).markers;
  markers.metres_per_unit.reset();
  const Score upright = score_of(without_names(markers));
  Eigen::Matrix3d z_up;
  z_up << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  const Eigen::Matrix3d upside_down = Eigen::Vector3d(-1, -1, 1).asDiagonal();
  const Eigen::Matrix3d half_turn = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  for (const Eigen::Matrix3d& by : {Eigen::Matrix3d(1000 * z_up), upside_down, half_turn}) {
    const Score score = score_of(without_names(changed(markers, by)));
    EXPECT_GE(score.share, upright.share - 0.05);
    EXPECT_EQ(score.sure_and_wrong, 0);
  }
}

TEST(MarkerGuess, LeftAndRightAreThoseOfThePersonAlsoInAMirror) {
  const Nameless nameless = without_names(test::marked_body(60, 0.15).markers);
  Nameless mirrored = nameless;
  mirrored.markers = changed(nameless.markers, Eigen::Vector3d(-1, 1, 1).asDiagonal());
  for (auto& [point, name] : mirrored.name_of)
    if (name.size() == 4 && (name[0] == 'L' || name[0] == 'R')) name[0] = name[0] == 'L' ? 'R' : 'L';
  EXPECT_GE(score_of(mirrored).share, 0.85);
}

TEST(MarkerGuess, BridgesGapsAndIsLessSureOfNoise) {
  Nameless nameless = without_names(test::marked_body(60, 0.15).markers);
  const auto clean = guess_markers(nameless.markers);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.05);
  for (Positions& frame : nameless.markers.frames)
    for (Eigen::Index p = 0; p < frame.rows(); ++p) {
      frame.row(p) += Eigen::RowVector3d(noise(random), noise(random), noise(random));
      if (random() % 10 == 0) frame.row(p).setConstant(std::nan(""));
    }
  const auto noisy = guess_markers(nameless.markers);
  ASSERT_TRUE(clean);
  ASSERT_TRUE(noisy) << noisy.error().text();
  EXPECT_LT(noisy->confidence, clean->confidence) << "distances within a segment change";
}

TEST(MarkerGuess, OnlyWhatIsSureGoesIntoTheModelUnlessAskedFor) {
  const Nameless nameless = without_names(test::marked_body(60, 0.15).markers);
  const auto guess = guess_markers(nameless.markers);
  ASSERT_TRUE(guess);
  const auto named = [](const MarkerModel& model) {
    int count = 0;
    for (const auto& sides : model.names)
      for (const auto& names : sides) count += names.empty() ? 0 : 1;
    return count;
  };
  const int sure = named(guess->model(nameless.markers, sure_enough_of_marker));
  EXPECT_LT(sure, named(guess->model(nameless.markers, 0)));
  const MarkerModel all = guess->model(nameless.markers, 0);
  const auto again = parse_marker_model(marker_model_json(all), "guess.json");
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_EQ(again->names, all.names);
}

TEST(MarkerGuess, SaysWhatItNeeds) {
  NamedMotion few = test::marked_body(5, 0.15).markers;
  few.points.resize(11);
  for (Positions& frame : few.frames) frame.conservativeResize(11, 3);
  EXPECT_THAT(guess_markers(few).error().message, HasSubstr("needs 12 markers"));
  NamedMotion unseen = test::marked_body(5, 0.15).markers;
  for (Positions& frame : unseen.frames) frame.setConstant(std::nan(""));
  EXPECT_THAT(guess_markers(unseen).error().message, HasSubstr("no frame in which"));
  NamedMotion flat = test::marked_body(5, 0.15).markers;
  flat.up_axis = UpAxis::Y;
  for (Positions& frame : flat.frames) frame.col(1).setZero();
  EXPECT_THAT(guess_markers(flat).error().message, HasSubstr("at one height"));
}

}  // namespace
}  // namespace abrazo::marker_guess_test
