#include "core/evaluation/tables/published_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "core/evaluation/takes/take_synthesis.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "tests/core/evaluation/evaluation_takes.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::published_table_test {
namespace {

/// Two takes of 10 s and their library.
EvaluationData two_takes() {
  EvaluationData data;
  data.takes = {test::swinging_take("first", 600, 1), test::swinging_take("second", 600, 2)};
  data.library = std::make_shared<const MotionLibrary>(*build_library("two", data.takes, {}, {}));
  return data;
}

PublishedTable measured(const EvaluationData& data, const Vec3& partner_offset, bool left_out = true) {
  std::vector<SynthesisedTake> answers;
  for (const PairedTake& take : data.takes) {
    answers.push_back(test::answered(take, test::own_pairs(*data.library, take), partner_offset));
    answers.back().of_library = left_out;
  }
  const auto table = measure_published(answers, data.library, false);
  EXPECT_TRUE(table) << table.error().text();
  return *table;
}

TEST(PublishedTable, TheRecordingIsWithoutErrorAndTheAimOfTheOtherFigures) {
  const PublishedTable table = measured(two_takes(), Vec3::Zero());
  EXPECT_EQ(table.clips, 10) << "of 2 s";
  EXPECT_EQ(table.captured.mpjpe_m, 0);
  EXPECT_NEAR(table.captured.fid_cd, 0, 1e-6);
  EXPECT_NEAR(table.captured.contact_f1, 1, 1e-12);
  EXPECT_GT(table.captured.diversity, 0);
  for (const PublishedRow& row : published_rows())
    EXPECT_NEAR(table.made.*row.figure, table.captured.*row.figure, 1e-9)
        << row.key << ": the capture was the answer";
}

TEST(PublishedTable, APartnerMovedAsideIsOffByThatAndMovesTheSame) {
  const PublishedTable table = measured(two_takes(), Vec3(0.2, 0, 0));
  EXPECT_NEAR(table.made.mpjpe_m, 0.2, 1e-9);
  EXPECT_NEAR(table.made.mpjve_m, 0, 1e-9);
  EXPECT_NEAR(table.made.jitter_10_m_s3, table.captured.jitter_10_m_s3, 1e-6);
  EXPECT_NEAR(table.made.turned_away_share, table.captured.turned_away_share, 1e-12);
  EXPECT_GT(table.made.fid_cd, 1);
}

TEST(PublishedTable, TheNearestNeighbourIsOfAnotherTakeWhereTheOwnIsLeftOut) {
  const EvaluationData data = two_takes();
  EXPECT_GT(measured(data, Vec3::Zero()).nearest.mpjpe_m, 0.02);
  // Of the whole library it is the recorded frame itself, but for heights and the library's one body.
  EXPECT_LT(measured(data, Vec3::Zero(), false).nearest.mpjpe_m, 0.01);
}

TEST(PublishedTable, OfNothingThereIsNothing) {
  const auto table = measure_published({}, two_takes().library, false);
  ASSERT_TRUE(table);
  EXPECT_EQ(table->clips, 0);
}

TEST(PublishedTable, EveryRowHasAFigureOfItsOwn) {
  std::set<std::string_view> keys;
  for (const PublishedRow& row : published_rows()) {
    EXPECT_NE(row.figure, nullptr);
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
  }
  EXPECT_EQ(keys.size() * sizeof(double), sizeof(PublishedFigures));
}

}  // namespace
}  // namespace abrazo::published_table_test
