#include "core/annotation/annotated_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "core/library/build/motion_library_builder.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::annotated_library_test {
namespace {

using ::testing::HasSubstr;

constexpr double rounding_m = 1e-12;

std::vector<PairedTake> two_takes() {
  std::vector<PairedTake> takes = {test::swinging_take("one", 40, 1), test::swinging_take("two", 30, 2)};
  takes[0].roles = {{0, 15, ActivePerformer::A}, {20, 40, ActivePerformer::B}};
  takes[0].labels = {{0, 12, "basic", "", ""}, {12, 40, "turn", "to the right", "low"}};
  takes[1].roles = {{0, 30, ActivePerformer::A}};
  takes[1].labels = {{5, 20, "swing", "", ""}};
  return takes;
}

MotionLibrary built(std::vector<PairedTake> takes, const LibraryBuildOptions& options = {}) {
  auto library = build_library("two", std::move(takes), options, {});
  EXPECT_TRUE(library) << library.error().text();
  return std::move(*library);
}

/// Each tetrahedron with ascending vertices, ascending.
std::vector<MeshTetrahedron> sorted(std::span<const MeshTetrahedron> tetrahedra) {
  std::vector<MeshTetrahedron> all(tetrahedra.begin(), tetrahedra.end());
  for (MeshTetrahedron& one : all) std::sort(one.begin(), one.end());
  std::sort(all.begin(), all.end());
  return all;
}

/// Whether the meshes too are those of the other library; otherwise but for few of their edges.
enum class Meshes { Same, SameButForTies };

/// Share of edges that only one of the two pairs' meshes has.
struct EdgeCount {
  double all = 0, different = 0;
  void add(std::span<const MeshEdge> a, std::span<const MeshEdge> b) {
    std::vector<MeshEdge> difference;
    std::ranges::set_symmetric_difference(a, b, std::back_inserter(difference));
    all += static_cast<double>(a.size());
    different += static_cast<double>(difference.size());
  }
};

void expect_equal(const MotionLibrary& found, const MotionLibrary& wanted, Meshes meshes = Meshes::Same) {
  EdgeCount edges;
  ASSERT_EQ(found.pair_count(), wanted.pair_count());
  for (int pair = 0; pair < wanted.pair_count(); ++pair) {
    const PairSource &is = found.source(pair), &should_be = wanted.source(pair);
    ASSERT_EQ(is.take, should_be.take);
    ASSERT_EQ(is.frame, should_be.frame);
    ASSERT_EQ(is.swapped, should_be.swapped);
    ASSERT_EQ(is.annotated, should_be.annotated);
    ASSERT_EQ(found.label(pair), wanted.label(pair));
    ASSERT_LE((found.pose(pair) - wanted.pose(pair)).cwiseAbs().maxCoeff(), rounding_m);
    ASSERT_LE((found.features(pair) - wanted.features(pair)).cwiseAbs().maxCoeff(), rounding_m);
    ASSERT_LE((found.root(pair).position - wanted.root(pair).position).norm(), rounding_m);
    ASSERT_NEAR(found.root(pair).heading_rad, wanted.root(pair).heading_rad, rounding_m);
    edges.add(found.edges(pair), wanted.edges(pair));
    if (meshes == Meshes::SameButForTies) continue;
    ASSERT_TRUE(std::ranges::equal(found.edges(pair), wanted.edges(pair))) << "pair " << pair;
    ASSERT_EQ(sorted(found.tetrahedra(pair)), sorted(wanted.tetrahedra(pair))) << "pair " << pair;
  }
  // Where points lie on one sphere, Delaunay is not unique, and TetGen decides by their order.
  EXPECT_LT(edges.different, 0.01 * edges.all);
  EXPECT_EQ(found.columns().mesh_quality, wanted.columns().mesh_quality);
  for (std::size_t t = 0; t < wanted.takes().size(); ++t) {
    EXPECT_EQ(found.takes()[t].roles.size(), wanted.takes()[t].roles.size());
    EXPECT_EQ(found.takes()[t].labels.size(), wanted.takes()[t].labels.size());
  }
  EXPECT_EQ(found.bodies().size(), wanted.bodies().size());
}

/// With which roles and labels, and how the library was built.
void expect_like_a_rebuild(const TakeAnnotation& annotation, const LibraryBuildOptions& options = {}) {
  std::vector<PairedTake> takes = two_takes();
  const MotionLibrary before = built(takes, options);
  takes[0].roles = annotation.roles;
  takes[0].labels = annotation.labels;
  const auto annotated = with_annotations(before, {{"one", annotation}});
  ASSERT_TRUE(annotated) << annotated.error().text();
  expect_equal(*annotated, built(takes, options), Meshes::SameButForTies);
}

const TakeAnnotation other_annotation = {
    {{0, 5, ActivePerformer::B}, {10, 17, ActivePerformer::A}, {17, 35, ActivePerformer::B}},
    {{3, 9, "wave", "", ""}, {30, 40, "basic", "", "high"}}};

TEST(AnnotatedLibrary, IsTheOneBuiltWithTheseRolesAndLabels) {
  expect_like_a_rebuild(other_annotation);
}

TEST(AnnotatedLibrary, HasBothAssignmentsWhereNothingIsSaid) {
  expect_like_a_rebuild({});
}

TEST(AnnotatedLibrary, MayExchangeTheRolesThroughout) {
  expect_like_a_rebuild({{{0, 40, ActivePerformer::B}}, {}});
}

TEST(AnnotatedLibrary, IsTheOneBuiltWhenThinnedToo) {
  expect_like_a_rebuild(other_annotation, {{}, 20.0});
}

TEST(AnnotatedLibrary, KeepsBothAssignmentsOfALibraryThatHasBoth) {
  expect_like_a_rebuild(other_annotation, {{}, {}, true});
}

TEST(AnnotatedLibrary, APairWhoseRolesChangeKeepsItsMeshWithTheBodiesExchanged) {
  const MotionLibrary before = built(two_takes());
  const auto after = with_annotations(before, {{"one", {{{0, 40, ActivePerformer::B}}, {}}}});
  ASSERT_TRUE(after);
  std::vector<MeshEdge> wanted;
  for (const MeshEdge& edge : before.edges(before.find_pair("one", 3, false))) {
    const auto a = static_cast<std::uint8_t>((edge[0] + joint_count) % pair_vertex_count),
               b = static_cast<std::uint8_t>((edge[1] + joint_count) % pair_vertex_count);
    wanted.push_back({std::min(a, b), std::max(a, b)});
  }
  std::sort(wanted.begin(), wanted.end());
  EXPECT_TRUE(std::ranges::equal(after->edges(after->find_pair("one", 3, true)), wanted));
  EXPECT_EQ(after->find_pair("one", 3, false), -1);
}

TEST(AnnotatedLibrary, TakesBackAnAnnotation) {
  const MotionLibrary before = built(two_takes());
  const auto there = with_annotations(before, {{"one", other_annotation}});
  ASSERT_TRUE(there);
  const auto back = with_annotations(*there, {{"one", {before.takes()[0].roles, before.takes()[0].labels}}});
  ASSERT_TRUE(back);
  expect_equal(*back, before);
}

TEST(AnnotatedLibrary, WithExchangedRolesStaysSo) {
  const MotionLibrary before = built(two_takes());
  const auto annotated = with_annotations(with_roles_exchanged(before), {{"one", other_annotation}});
  ASSERT_TRUE(annotated);
  EXPECT_TRUE(annotated->columns().roles_exchanged);
  expect_equal(*annotated, with_roles_exchanged(*with_annotations(before, {{"one", other_annotation}})));
}

TEST(AnnotatedLibrary, RefusesWhatDoesNotFit) {
  const MotionLibrary library = built(two_takes());
  EXPECT_THAT(with_annotations(library, {{"three", {}}}).error().text(),
              HasSubstr("no take 'three'; it has one, two"));
  EXPECT_THAT(with_annotations(library, {{"one", {{}, {{5, 5, "x", "", ""}}}}}).error().text(),
              HasSubstr("label 0 [5, 5) is empty"));
  EXPECT_THAT(
      with_annotations(library, {{"one", {{{0, 9, ActivePerformer::A}, {5, 12, ActivePerformer::B}}, {}}}})
          .error()
          .text(),
      HasSubstr("role 1 [5, 12)"));
}

TEST(TakeAnnotations, OfATakeAreItsRolesAndLabels) {
  const MotionLibrary library = built(two_takes());
  const Annotations annotations = annotations_of_take(library, "one");
  const auto tiers = tiers_of(annotations);
  ASSERT_EQ(tiers.size(), 2u);
  EXPECT_EQ(tiers[0],
            (Tier{"role", {{0, 0.25, "a"}, {20 / 60.0, 40 / 60.0, "b"}}, {{"a"}, {"b"}}, TierKind::Role}));
  EXPECT_EQ(tiers[1], (Tier{"move",
                            {{0, 0.2, "basic"}, {0.2, 40 / 60.0, "turn", "to the right", "low"}},
                            {{"basic"}, {"turn"}, {"swing"}},
                            TierKind::Move}));
  EXPECT_THROW(annotations_of_take(library, "three"), std::invalid_argument);
}

TEST(TakeAnnotations, ComeBackToTheSameFrames) {
  const MotionLibrary library = built(two_takes());
  const LibraryTake& take = library.takes()[0];
  const auto back = take_annotation(annotations_of_take(library, "one"), take.fps, take.frames);
  ASSERT_TRUE(back);
  ASSERT_EQ(back->roles.size(), 2u);
  EXPECT_EQ(back->roles[1].start, 20);
  EXPECT_EQ(back->roles[1].end, 40);
  EXPECT_EQ(back->roles[1].active, ActivePerformer::B);
  ASSERT_EQ(back->labels.size(), 2u);
  EXPECT_EQ(back->labels[1].start, 12);
  EXPECT_EQ(back->labels[1].detail, "to the right");
  EXPECT_EQ(back->labels[1].confidence, "low");
}

TEST(TakeAnnotations, AreRoundedToFramesAndEndWithTheTake) {
  const auto annotations = annotations_of(
      std::vector<Tier>{{"role", {{0, 1.26, "a"}, {1.26, 30, "b"}}, {}, TierKind::Role},
                        {"move",
                         {{0, 0.94, "x"}, {0.94, 0.96, ""}, {1.01, 1.04, "too short"}, {2.5, 3, "late"}},
                         {},
                         TierKind::Move}});
  ASSERT_TRUE(annotations);
  const auto taken = take_annotation(*annotations, 10, 20);
  ASSERT_TRUE(taken);
  ASSERT_EQ(taken->roles.size(), 2u);
  EXPECT_EQ(taken->roles[0].end, 13);
  EXPECT_EQ(taken->roles[1].end, 20);
  ASSERT_EQ(taken->labels.size(), 1u);
  EXPECT_EQ(taken->labels[0].end, 9);
}

TEST(TakeAnnotations, ARoleThatIsNoPerformerIsRefused) {
  const auto annotations =
      annotations_of(std::vector<Tier>{{"who leads", {{1, 2, "leader"}}, {}, TierKind::Role}});
  EXPECT_THAT(take_annotation(*annotations, 60, 100).error().text(),
              HasSubstr("who leads: 'leader' at 1.000 s is not a role; say a or b"));
}

}  // namespace
}  // namespace abrazo::annotated_library_test
