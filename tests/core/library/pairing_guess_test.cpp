#include "core/library/build/pairing_guess.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <filesystem>

#include "core/library/takes/performer_name.hpp"
#include "tests/core/library/synthetic_takes.hpp"

namespace abrazo::pairing_guess_test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Performers of made-up files, each given as its path; two of one take are a couple that circles.
class Pairing : public testing::Test {
 protected:
  /// @param follower  the second of the two people of the take
  void add(const std::string& file, int frames, bool follower, double distance_m = 0.8,
           const std::string& skeleton = "") {
    const PairedTake take = test::circling_take("t", frames, distance_m);
    clips.push_back(follower ? take.b : take.a);
    performers.push_back({file, file, skeleton, &clips.back(), 1});
  }
  /// "60_01+61_01" for each pair.
  std::vector<std::string> pairs() const {
    std::vector<std::string> found;
    for (const PairGuess& guess : guess_pairs(performers))
      found.push_back(stem(guess.a) + "+" + stem(guess.b));
    return found;
  }
  std::string stem(std::size_t performer) const {
    return std::filesystem::path(performers[performer].file).stem().string();
  }
  PairGuess only() const {
    const auto guesses = guess_pairs(performers);
    EXPECT_EQ(guesses.size(), 1U);
    return guesses.empty() ? PairGuess{} : guesses.front();
  }
  std::deque<Clip> clips;
  std::vector<LonePerformer> performers;
};

TEST_F(Pairing, TellsSubjectsFromTakesInNumberedFiles) {
  for (const auto& [take, frames] : {std::pair("01", 40), {"02", 50}, {"03", 60}})
    for (const bool follower : {false, true})
      add(std::string("d/") + (follower ? "61_" : "60_") + take + ".amc", frames, follower, 0.8,
          follower ? "61.asf" : "60.asf");
  EXPECT_THAT(pairs(), ElementsAre("60_01+61_01", "60_02+61_02", "60_03+61_03"));
  EXPECT_EQ(guess_pairs(performers)[0].take, "take_01");
  EXPECT_EQ(guess_pairs(performers)[0].confidence(), Confidence::Sure);
  EXPECT_FALSE(guess_pairs(performers)[0].roles_known) << "numbers do not say who leads";
}

TEST_F(Pairing, AFileOfSomebodyElseDoesNotConfuseIt) {
  for (const auto& [take, frames] : {std::pair("01", 40), {"02", 50}, {"03", 60}, {"04", 70}})
    for (const bool follower : {false, true})
      add(std::string(follower ? "61_" : "60_") + take + ".amc", frames, follower, 0.8,
          follower ? "61.asf" : "60.asf");
  add("02_05.amc", 90, false, 0.8, "02.asf");
  EXPECT_THAT(pairs(), ElementsAre("60_01+61_01", "60_02+61_02", "60_03+61_03", "60_04+61_04"));
  EXPECT_EQ(guess_pairs(performers)[3].confidence(), Confidence::Sure);
}

TEST_F(Pairing, TellsSubjectsFromTakesAlsoWhereTheSubjectComesLast) {
  for (const auto& [take, frames] : {std::pair("take1", 40), {"take2", 50}, {"take3", 60}})
    for (const bool follower : {false, true})
      add(std::string(take) + (follower ? "_2.bvh" : "_1.bvh"), frames, follower);
  EXPECT_THAT(pairs(), ElementsAre("take1_1+take1_2", "take2_1+take2_2", "take3_1+take3_2"));
}

TEST_F(Pairing, ReadsTheRolesFromWords) {
  add("a_take1_follower.bvh", 40, true);
  add("a_take1_leader.bvh", 40, false);
  const PairGuess guess = only();
  EXPECT_TRUE(guess.roles_known);
  EXPECT_EQ(stem(guess.a), "a_take1_leader") << "the active one is a";
  EXPECT_EQ(guess.take, "a_take1");
  EXPECT_EQ(guess.confidence(), Confidence::Sure);
}

TEST_F(Pairing, ReadsRolesInOddSpellings) {
  for (const auto& [active, passive] : {std::pair("TangoMan", "TangoWoman"),
                                        {"s60 LEADER", "s61 Follower"},
                                        {"x-attacker-3", "x-defender-3"}}) {
    performers.clear();
    add(std::string(passive) + ".bvh", 40, true);
    add(std::string(active) + ".bvh", 40, false);
    EXPECT_TRUE(only().roles_known) << active;
    EXPECT_EQ(stem(only().a), active);
  }
}

TEST_F(Pairing, PairsLettersAndCamelCase) {
  add("sparringA.bvh", 40, false);
  add("sparringB.bvh", 40, true);
  add("walk_A.bvh", 50, false);
  add("walk_B.bvh", 50, true);
  EXPECT_THAT(pairs(), ElementsAre("sparringA+sparringB", "walk_A+walk_B"));
  EXPECT_EQ(guess_pairs(performers)[0].take, "sparring");
  EXPECT_EQ(guess_pairs(performers)[1].take, "walk");
}

TEST_F(Pairing, PairsAFileWithTheOneThatAddsThePartner) {
  add("duet.bvh", 40, false);
  add("duet_partner.bvh", 40, true);
  EXPECT_EQ(only().take, "duet");
  EXPECT_TRUE(only().roles_known);
}

TEST_F(Pairing, PairsTheTwoOfOneFile) {
  add("both.bvh", 40, false);
  add("both.bvh", 40, true);
  performers[0].name = "Hips", performers[1].name = "Hips_2";
  performers[0].in_the_file = performers[1].in_the_file = 2;
  EXPECT_EQ(only().confidence(), Confidence::Sure);
  EXPECT_EQ(only().take, "both");
  EXPECT_THAT(only().reason, HasSubstr("one file"));
}

TEST_F(Pairing, TwoOfOneFileAreTwoPeopleThoughTheirBonesAreAlike) {
  add("both.bvh", 40, false);
  add("both.bvh", 40, false);
  performers[0].name = "Hips", performers[1].name = "Hips_2";
  performers[0].in_the_file = performers[1].in_the_file = 2;
  EXPECT_THAT(only().reason, Not(HasSubstr("same bone lengths")));
}

TEST_F(Pairing, LengthAndNearnessPairNamesThatSayNothing) {
  add("anything.bvh", 40, false);
  add("other_thing_here.bvh", 55, false);
  add("whatever.bvh", 40, true);
  EXPECT_THAT(pairs(), ElementsAre("anything+whatever"));
  EXPECT_NE(guess_pairs(performers)[0].confidence(), Confidence::Sure);
}

TEST_F(Pairing, OfNumberedFilesWithoutAnyOtherSignLengthDecides) {
  add("60_01.bvh", 40, false), add("60_02.bvh", 50, false);
  add("61_01.bvh", 40, true), add("61_02.bvh", 50, true);
  EXPECT_THAT(pairs(), ElementsAre("60_01+61_01", "60_02+61_02"));
}

TEST_F(Pairing, TakesOfOnePersonAreNoPair) {
  add("60_01.amc", 40, false, 0.8, "60.asf");
  add("60_02.amc", 50, false, 0.8, "60.asf");
  add("60_03.amc", 60, false, 0.8, "60.asf");
  EXPECT_THAT(pairs(), IsEmpty());
}

TEST_F(Pairing, TwoFilesAloneAreAlwaysProposedButWithTheirDoubts) {
  add("morning.bvh", 40, false);
  add("evening_walk.bvh", 90, false);
  const PairGuess guess = only();
  EXPECT_EQ(guess.confidence(), Confidence::Unsure);
  EXPECT_THAT(guess.take, HasSubstr("+"));
}

TEST_F(Pairing, SaysWhy) {
  add("60_01.bvh", 40, false);
  add("61_01.bvh", 40, true);
  EXPECT_EQ(only().reason, "names differ in 60, 61; 40 frames each; 0.80 m apart");
}

TEST_F(Pairing, FarApartCountsLess) {
  add("x_A.bvh", 40, false);
  add("x_B.bvh", 40, true);
  const double near = only().evidence;
  clips.clear(), performers.clear();
  add("x_A.bvh", 40, false, 20);
  add("x_B.bvh", 40, true, 20);
  EXPECT_NEAR(near - only().evidence, 0.2, 1e-9) << "the share of nearness";
}

TEST_F(Pairing, GivesNoTwoPairsOneName) {
  add("mon/x_A.bvh", 40, false), add("mon/x_B.bvh", 40, true);
  add("tue/x_A.bvh", 60, false), add("tue/x_B.bvh", 60, true);
  const auto guesses = guess_pairs(performers);
  ASSERT_EQ(guesses.size(), 2U);
  EXPECT_EQ(guesses[0].take, "mon_x");
  EXPECT_EQ(guesses[1].take, "tue_x");
}

TEST(PartsOfName, SplitAtDigitsCapitalsAndSeparators) {
  std::vector<std::string> texts;
  for (const NamePart& part : parts_of_name("takeTwo_61b-X")) texts.push_back(part.text);
  EXPECT_THAT(texts, ElementsAre("take", "two", "61", "b", "x"));
}

std::optional<NameDifference> difference_of(const char* first, const char* second) {
  return difference_of_names(parts_of_name(first), parts_of_name(second));
}

TEST(DifferenceOfNames, IsNothingForNamesThatAreNotOfOneTake) {
  EXPECT_FALSE(difference_of("walk_01", "walk_01"));
  EXPECT_FALSE(difference_of("walk_01", "jump_02"));
  EXPECT_FALSE(difference_of("walk_01", "walk_fast"));
  EXPECT_FALSE(difference_of("", "b"));
}

TEST(DifferenceOfNames, IsOfLettersOnlyWhenBothAreOne) {
  EXPECT_EQ(difference_of("walk_a", "walk_b")->contrast, NameContrast::Letters);
  EXPECT_EQ(difference_of("walk_anna", "walk_b")->contrast, NameContrast::Words);
  EXPECT_EQ(difference_of("walk_a", "walk_ben")->contrast, NameContrast::Words);
  EXPECT_EQ(difference_of("walk_anna", "walk_ben")->contrast, NameContrast::Words);
}

TEST(DifferenceOfNames, IsOfPerformersOrOfTakesByTheWordBeforeANumber) {
  EXPECT_EQ(difference_of("10_C0", "10_C1")->contrast, NameContrast::Performers);
  EXPECT_EQ(difference_of("person1/7", "person2/7")->contrast, NameContrast::Performers);
  EXPECT_EQ(difference_of("walk_1", "walk_2")->contrast, NameContrast::Numbers);
  EXPECT_FALSE(difference_of("take1", "take2"));
  EXPECT_FALSE(difference_of("seq_1/0/motion", "seq_2/0/motion"));
}

TEST(SharedName, KeepsOneSeparatorBetweenTheParts) {
  const auto shared = [](const char* first, const char* second) {
    return shared_name(first, *difference_of(first, second));
  };
  EXPECT_EQ(shared("walk_a_01", "walk_b_01"), "walk_01");
  EXPECT_EQ(shared("a_walk_01", "b_walk_01"), "walk_01");
  EXPECT_EQ(shared("walk_01_a", "walk_01_b"), "walk_01");
  EXPECT_EQ(shared("10_C0", "10_C1"), "10");
  EXPECT_EQ(shared("s_1/0/x", "s_1/1/x"), "s_1/x");
  EXPECT_EQ(shared("s/p1", "s/p2"), "s");
}

TEST(GuessSkeleton, TakesTheOneWhoseNameBeginsTheMotions) {
  const std::vector<std::string> skeletons = {"/d/60.asf", "/d/61.asf"};
  EXPECT_EQ(guess_skeleton("/m/61_01.amc", skeletons), "/d/61.asf");
  EXPECT_EQ(guess_skeleton("/m/62_01.amc", skeletons), "");
  EXPECT_EQ(guess_skeleton("/m/62_01.amc", std::vector<std::string>{"/d/60.asf"}), "/d/60.asf");
}

TEST(GuessLabelledTake, FindsTheNameByItsNumber) {
  const std::vector<std::string> labelled = {"salsa_01", "salsa_02", "tango_7", "fight_7"};
  EXPECT_EQ(guess_labelled_take("take_01", labelled), "salsa_01");
  EXPECT_EQ(guess_labelled_take("Salsa 02", labelled), "salsa_02");
  EXPECT_EQ(guess_labelled_take("take_7", labelled), "") << "two have that number";
  EXPECT_EQ(guess_labelled_take("take", labelled), "");
}

}  // namespace
}  // namespace abrazo::pairing_guess_test
