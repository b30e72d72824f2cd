#include "core/choreography/salsa_phrase.hpp"

#include <gtest/gtest.h>

#include <map>

namespace abrazo {
namespace {

TEST(SalsaPhrase, EveryMoveComesTwiceInEight) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    RandomSource random(seed);
    const auto phrases = draw_phrases(16, random);
    for (std::size_t first : {0U, 8U}) {
      std::map<SalsaMove, int> count;
      for (std::size_t i = first; i < first + 8; ++i) ++count[phrases[i].move];
      EXPECT_EQ(count[SalsaMove::OpenHold], 2);
      EXPECT_EQ(count[SalsaMove::ClosedHold], 2);
      EXPECT_EQ(count[SalsaMove::Turn], 2);
      EXPECT_EQ(count[SalsaMove::CrossBodyLead], 2);
    }
  }
}

TEST(SalsaPhrase, NoTwoAreDancedAlike) {
  RandomSource random(3);
  const auto phrases = draw_phrases(30, random);
  for (std::size_t i = 1; i < phrases.size(); ++i) EXPECT_NE(phrases[i].step, phrases[i - 1].step);
}

TEST(SalsaPhrase, TheCoupleStaysAroundTheOrigin) {
  RandomSource random(5);
  Vec3 centre = Vec3::Zero();
  for (const SalsaPhrase& phrase : draw_phrases(500, random)) {
    centre += phrase.travel;
    EXPECT_LT(centre.norm(), 1.5);
  }
}

TEST(SalsaPhrase, TheCoupleTurnsFromNothingToAllOfIt) {
  for (const SalsaMove move : {SalsaMove::OpenHold, SalsaMove::Turn, SalsaMove::CrossBodyLead}) {
    EXPECT_EQ(couple_progress(move, -0.5), 0);
    EXPECT_EQ(couple_progress(move, 7.5), 1);
  }
}

TEST(RandomSource, GivesTheSameNumbersOnEveryPlatform) {
  // The standard fixes the 10000th output of a default-seeded mt19937_64: 9981545732273789042.
  RandomSource random(5489);
  double last = 0;
  for (int i = 0; i < 10000; ++i) last = random.uniform(0, 1);
  EXPECT_DOUBLE_EQ(last, static_cast<double>(9981545732273789042ULL >> 11) * 0x1.0p-53);
}

}  // namespace
}  // namespace abrazo
