#include "core/library/store/neighbour_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/library/build/motion_library_builder.hpp"
#include "tests/core/library/synthetic_takes.hpp"

namespace abrazo::neighbour_distance_test {
namespace {

/// A library whose features are made up: frame by frame, take by take.
MotionLibrary library_with(const std::vector<std::vector<double>>& first_coordinates) {
  std::vector<PairedTake> takes;
  for (std::size_t t = 0; t < first_coordinates.size(); ++t) {
    takes.push_back(
        test::circling_take("t" + std::to_string(t), static_cast<int>(first_coordinates[t].size())));
    takes.back().roles = {{0, static_cast<int>(first_coordinates[t].size()), ActivePerformer::A}};
  }
  LibraryColumns columns = build_library("l", std::move(takes), {}, {})->columns();
  std::size_t pair = 0;
  for (const auto& take : first_coordinates)
    for (const double x : take) columns.features[pair] = Features::Zero(), columns.features[pair++][0] = x;
  return MotionLibrary(std::move(columns));
}

TEST(TypicalNeighbourDistance, IsTheMedianOfTheNearestOfAnotherTake) {
  // nearest of the other take: 0.1, 0.4, 1.6 and 0.1, 0.4, 3.0
  const MotionLibrary library = library_with({{0.0, 1.0, 3.0}, {-0.1, 1.4, 6.0}});
  const auto distance = typical_neighbour_distance(library);
  ASSERT_TRUE(distance);
  EXPECT_NEAR(*distance, 0.4, 1e-12) << "of 0.1, 0.1, 0.4, 0.4, 1.6, 3.0 the upper middle";
}

TEST(TypicalNeighbourDistance, DoesNotCountTheSameSecondOfATake) {
  EXPECT_FALSE(typical_neighbour_distance(library_with({{0, 1, 2}}))) << "all within a second";
  std::vector<double> long_take(200);
  for (std::size_t i = 0; i < long_take.size(); ++i) long_take[i] = static_cast<double>(i);
  EXPECT_NEAR(*typical_neighbour_distance(library_with({long_take})), 61, 1e-12) << "60 frames a second";
}

TEST(TypicalNeighbourDistance, StopsWhenAsked) {
  EXPECT_FALSE(typical_neighbour_distance(library_with({{0, 1}, {2, 3}}), 400,
                                          [](double, std::string_view) { return false; }));
}

}  // namespace
}  // namespace abrazo::neighbour_distance_test
