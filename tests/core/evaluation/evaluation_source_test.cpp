#include "core/evaluation/run/evaluation_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace abrazo::evaluation_source_test {
namespace {

using ::testing::ElementsAre;
using ::testing::SizeIs;

std::set<EvaluationPart> parts_of(const std::vector<std::string>& names) {
  const auto parts = evaluation_parts(names);
  EXPECT_TRUE(parts.ok());
  return parts.ok() ? parts.value() : std::set<EvaluationPart>{};
}

TEST(EvaluationParts, AreFoundByTheirNames) {
  EXPECT_THAT(parts_of({"contact", "selection", "contact"}),
              ElementsAre(EvaluationPart::Selection, EvaluationPart::Contact));
  EXPECT_THAT(parts_of({"timing", "moves", "zmp"}),
              ElementsAre(EvaluationPart::Timing, EvaluationPart::Moves, EvaluationPart::Zmp));
}

TEST(EvaluationParts, AreAllOfThemWithOneWord) {
  EXPECT_THAT(parts_of({"zmp", "all"}), SizeIs(evaluation_part_names.size()));
}

TEST(EvaluationParts, ThatThereAreNotAreRefusedWithThoseThereAre) {
  const std::vector<std::string> names = {"moves", "tempo"};
  EXPECT_EQ(evaluation_parts(names).error().text(),
            "'tempo' is no part of the evaluation; there are selection, timing, moves, zmp, contact, "
            "published, bodies, and all");
}

}  // namespace
}  // namespace abrazo::evaluation_source_test
