#include "core/selection/intent_selector.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "tests/core/selection/user_motions.hpp"
#include "tests/support/bodies.hpp"
#include "tests/support/libraries.hpp"

namespace abrazo::intent_selector_test {
namespace {

/// A landing is read by one product for all and a pair by itself: float rounding of some squares.
constexpr double rounding_m = 2e-4;
constexpr double belief_width_m = 0.03;

const std::shared_ptr<const IntentModel>& model() {
  static const auto learned = [] {
    auto library = test::small_library();
    const std::vector<int> pairs = test::all_pairs(*library);
    return IntentModel::learn(std::move(library), pairs);
  }();
  return learned;
}

const MotionLibrary& library() {
  return *model()->library();
}

const std::vector<Pose>& first_leader() {
  static const std::vector<Pose> poses = test::swinging_take("first", 180, 1).a.poses;
  return poses;
}

/// Dances like nobody in the library.
const std::vector<Pose>& stranger() {
  static const std::vector<Pose> poses = [] {
    std::mt19937 random(1);
    std::vector<Pose> noisy = test::swinging_take("user", 200, 17).a.poses;
    for (Pose& pose : noisy) pose = test::shaken(pose, 0.02, random);
    return noisy;
  }();
  return poses;
}

struct Choice {
  int selected = -1;
  std::vector<Candidate> candidates;
  FrameIntent intent;
  const Candidate& chosen() const { return candidates.at(static_cast<std::size_t>(selected)); }
};

class IntentSelectorTest : public testing::Test {
 protected:
  SelectionQuery query_of(const Pose& pose) const {
    SelectionQuery query;
    query.root = root_frame(pose);
    query.normalized = to_normalized(pose, query.root);
    query.features = pose_features(query.normalized);
    query.neighbours = neighbours;
    query.current_pair = current_pair;
    return query;
  }
  Choice choose(const std::vector<Pose>& user, int frame) {
    Choice choice;
    choice.selected =
        selector.select(query_of(user[static_cast<std::size_t>(frame)]), test::history_at(user, frame),
                        selectable, weights, choice.candidates, choice.intent);
    return choice;
  }
  /// What a landing costs, term by term as it is defined; without the margin.
  std::vector<double> totals_by_hand(const std::vector<Pose>& user, int frame) const {
    IntentModel::Reading reading = model()->make_reading();
    model()->read(test::history_at(user, frame), reading);
    std::vector<double> totals;
    for (const int landing : model()->landings()) {
      const IntentModel::PairReading read = model()->read_pair(landing, reading);
      const double likely = static_cast<double>(reading.moves[static_cast<std::size_t>(read.label)]);
      const double total = static_cast<double>(read.partner_m) +
                           weights.leader * (1 - static_cast<double>(read.leader_kernel)) +
                           weights.move * (1 - likely) +
                           (selectable.is_not_intended(landing) ? weights.meant : 0);
      totals.push_back(selectable.is_vetoed(landing) ? std::numeric_limits<double>::infinity() : total);
    }
    return totals;
  }
  /// Follows the user from the first frame on. @return how often another source was chosen
  int changes_over(const std::vector<Pose>& user) {
    int changes = 0;
    current_pair = -1;
    for (int frame = 0; frame < static_cast<int>(user.size()); ++frame) {
      const Choice choice = choose(user, frame);
      changes += current_pair >= 0 && !choice.chosen().continuation;
      current_pair = choice.chosen().pair;
    }
    return changes;
  }
  int pair(const char* take, int frame) const { return library().find_pair(take, frame, false); }

  IntentSelector selector{model()};
  SelectablePairs selectable{model()->library(), test::all_pairs(library())};
  IntentWeights weights;
  int neighbours = 10, current_pair = -1;
};

TEST_F(IntentSelectorTest, TermsAddUpAndTheLeastTotalIsChosen) {
  for (const int current : {-1, 50, 179}) {
    current_pair = current;
    for (const int frame : {0, 30, 100, 150}) {
      const Choice choice = choose(stranger(), frame);
      ASSERT_GE(choice.selected, 0);
      for (const Candidate& candidate : choice.candidates) {
        const IntentCost& cost = candidate.intent.value();
        EXPECT_DOUBLE_EQ(cost.total, cost.partner + cost.leader + cost.move + cost.meant + cost.change);
        EXPECT_GE(cost.total, choice.chosen().intent->total);
        EXPECT_EQ(deciding_cost(candidate), cost.total);
        for (const double term : {cost.leader, cost.move, cost.meant, cost.change}) EXPECT_GE(term, 0);
        EXPECT_LE(cost.leader, weights.leader);
        EXPECT_LE(cost.move, weights.move);
        EXPECT_EQ(cost.meant, 0);
        EXPECT_EQ(candidate.cost.total, candidate.cost.pose) << "Eq. 7 is told too";
        EXPECT_GT(candidate.cost.pose, 0);
      }
    }
  }
}

TEST_F(IntentSelectorTest, WhatAChangeDoesToHandsAndFeetIsPaidFor) {
  const Pose& user = stranger()[100];
  const auto cost_with = [&](const auto& change) {
    SelectionQuery query = query_of(user);
    query.alpha = 0.5;
    query.has_prediction = true;
    query.predicted = library().pair_in_world(60, query.root);
    change(query);
    return selector.candidate(60, query, selectable, weights, true).intent->temporal;
  };
  choose(stranger(), 100);
  const double nothing = cost_with([](SelectionQuery&) {});
  const double lost = cost_with([](SelectionQuery& query) { query.held.fill(true); });
  int without = 0;
  for (const int of_user : {joints::left_hand, joints::right_hand})
    for (const int of_partner : {joints::left_hand, joints::right_hand}) {
      bool holds = false;
      for (const int ahead : {0, 4, 8, 12}) {  // 0.2 s
        const PairPose pose = library().pose(60 + ahead);
        holds |= (pose.row(of_user) - pose.row(of_partner + joint_count)).norm() < hold_distance_m;
      }
      without += !holds;
    }
  EXPECT_GT(without, 0);
  EXPECT_NEAR(lost - nothing, 0.5 * without * 0.25, 1e-9);
  const double lifted = cost_with([](SelectionQuery& query) { query.planted.fill(true); });
  EXPECT_GE(lifted, nothing);
  EXPECT_LE(lifted, nothing + 0.5 * 2 * 0.05);
  EXPECT_EQ(cost_with([](SelectionQuery& query) { query.alpha = 0; }), 0);
}

TEST_F(IntentSelectorTest, NoLandingIsBetterThanTheChosenOne) {
  for (const IntentWeights& each : {IntentWeights{}, IntentWeights{0, 0, 0, 0}, IntentWeights{0.1, 2, 0, 0},
                                    IntentWeights{0.1, 2, 2, 2}, IntentWeights{0, 0.05, 2, 0}})
    for (const auto* user : {&first_leader(), &stranger()})
      for (int frame = 0; frame < 180; frame += 11) {
        weights = each;
        const std::vector<double> totals = totals_by_hand(*user, frame);
        const double least = *std::min_element(totals.begin(), totals.end());
        EXPECT_NEAR(choose(*user, frame).chosen().intent->total, least, rounding_m)
            << "frame " << frame << ", leader weight " << weights.leader;
      }
}

/// 0 to 255, of every block.
std::vector<double> beliefs_of(const std::vector<double>& totals) {
  const double least = *std::min_element(totals.begin(), totals.end());
  std::vector<double> beliefs(model()->blocks().size(), 0);
  for (std::size_t l = 0; l < totals.size(); ++l) {
    double& block = beliefs[static_cast<std::size_t>(model()->block_of_landing(l))];
    block = std::max(block, 255 * std::exp((least - totals[l]) / belief_width_m));
  }
  return beliefs;
}

TEST_F(IntentSelectorTest, TheBeliefOfABlockIsThatOfItsBestLanding) {
  weights.leader = 0;
  for (const int frame : {0, 40, 90, 170}) {
    const Choice choice = choose(stranger(), frame);
    ASSERT_EQ(choice.intent.belief.size(), model()->blocks().size());
    EXPECT_EQ(*std::max_element(choice.intent.belief.begin(), choice.intent.belief.end()), 255);
    const std::vector<double> beliefs = beliefs_of(totals_by_hand(stranger(), frame));
    for (std::size_t b = 0; b < beliefs.size(); ++b)
      EXPECT_NEAR(choice.intent.belief[b], beliefs[b], 3)
          << "block " << b << " at " << frame << ": rounded to 1/255, and " << rounding_m << " off";
    EXPECT_EQ(choice.intent.model, model());
    EXPECT_EQ(choice.intent.moves.size(), model()->labels().size());
  }
}

TEST_F(IntentSelectorTest, TheBeliefIsStrongestWhereTheChoiceIsWhateverTheLeaderWeighs) {
  for (const double leader : {0.2, 2.0})
    for (int frame = 0; frame < 180; frame += 9) {
      weights.leader = leader;
      const std::vector<double> totals = totals_by_hand(stranger(), frame);
      const auto best =
          static_cast<std::size_t>(std::min_element(totals.begin(), totals.end()) - totals.begin());
      const Choice choice = choose(stranger(), frame);
      const auto block = static_cast<std::size_t>(model()->block_of_landing(best));
      EXPECT_NEAR(choice.intent.belief[block], 255, 3) << "leader weight " << leader << ", frame " << frame;
    }
}

TEST_F(IntentSelectorTest, CandidatesAscendInFeatureDistanceAndAreNoMoreThanAsked) {
  for (const int current : {-1, 50})
    for (const int k : {1, 3, 10, 200}) {
      neighbours = k;
      current_pair = current;
      const Choice choice = choose(stranger(), 120);
      EXPECT_LE(choice.candidates.size(), static_cast<std::size_t>(k) + 1);
      EXPECT_GE(choice.candidates.size(), 1U);
      EXPECT_TRUE(std::is_sorted(
          choice.candidates.begin(), choice.candidates.end(),
          [](const auto& a, const auto& b) { return a.feature_distance < b.feature_distance; }));
      for (const Candidate& candidate : choice.candidates)
        EXPECT_NEAR(candidate.feature_distance,
                    (library().features(candidate.pair) - query_of(stranger()[120]).features).norm(), 1e-12);
    }
}

TEST_F(IntentSelectorTest, AMomentOfATakeIsProposedOnce) {
  neighbours = 200;
  for (int frame = 40; frame < 170; frame += 9) {
    current_pair = pair("first", frame - 1);  // what goes on is one of them
    const Choice choice = choose(first_leader(), frame);
    ASSERT_GT(choice.candidates.size(), 4U);
    for (std::size_t a = 0; a < choice.candidates.size(); ++a)
      for (std::size_t b = 0; b < a; ++b) {
        const int one = choice.candidates[a].pair, other = choice.candidates[b].pair;
        if (library().source(one).take == library().source(other).take) {
          EXPECT_GE(std::abs(one - other), 18) << "0.3 s at 60 Hz, frame " << frame;
        }
      }
  }
}

TEST_F(IntentSelectorTest, GoingOnIsMarkedAndCostsNoMargin) {
  weights.switch_margin = 0.25;
  for (const int frame : {40, 100, 150}) {
    current_pair = pair("first", frame - 1);
    const Choice choice = choose(first_leader(), frame);
    int marked = 0;
    for (const Candidate& candidate : choice.candidates) {
      EXPECT_EQ(candidate.intent->change, candidate.continuation ? 0 : 0.25);
      EXPECT_EQ(candidate.continuation, candidate.pair == choice.intent.continued);
      marked += candidate.continuation;
    }
    EXPECT_EQ(marked, 1);
    EXPECT_TRUE(choice.chosen().continuation) << "the user goes on too";
    EXPECT_GE(choice.intent.continued, current_pair);
    EXPECT_LE(choice.intent.continued, current_pair + 3) << "at most three times the pace";
  }
}

TEST_F(IntentSelectorTest, TheSourceIsGoneOnWithAtThePaceThatFits) {
  for (const int late : {0, 2, 4, 8, 12}) {
    current_pair = pair("first", 100);
    SelectionQuery query = query_of(first_leader()[static_cast<std::size_t>(100 + late)]);
    query.expected_advance = 4;
    Choice choice;
    weights = {0, 2, 0, 0};  // the leader's motion alone
    selector.select(query, test::history_at(first_leader(), 100 + late), selectable, weights,
                    choice.candidates, choice.intent);
    EXPECT_EQ(choice.intent.continued, current_pair + late);
  }
}

TEST_F(IntentSelectorTest, AtTheStartAndAtTheEndOfATakeNothingGoesOn) {
  for (const int current : {-1, pair("first", 179), pair("second", 149)}) {
    current_pair = current;
    const Choice choice = choose(stranger(), 100);
    EXPECT_EQ(choice.intent.continued, -1);
    for (const Candidate& candidate : choice.candidates) {
      EXPECT_FALSE(candidate.continuation);
      EXPECT_EQ(candidate.intent->change, current < 0 ? 0 : weights.switch_margin);
    }
  }
}

TEST_F(IntentSelectorTest, TheLargerTheMarginTheFewerChanges) {
  std::vector<int> changes;
  for (const double margin : {0.0, 0.02, 0.1, 0.5}) {
    weights.switch_margin = margin;
    changes.push_back(changes_over(stranger()));
  }
  EXPECT_TRUE(std::is_sorted(changes.rbegin(), changes.rend())) << testing::PrintToString(changes);
  EXPECT_GT(changes.front(), changes.back() + 3) << testing::PrintToString(changes);
}

TEST_F(IntentSelectorTest, WhatIsVetoedIsNeverProposed) {
  selectable.set_vetoes({{pair("second", 40), pair("second", 60)}, {"first"}, {"turn"}});
  for (const int current : {-1, pair("first", 30), pair("second", 39)})
    for (const auto* user : {&first_leader(), &stranger()})
      for (int frame = 0; frame < 180; frame += 20) {
        current_pair = current;
        const Choice choice = choose(*user, frame);
        ASSERT_GE(choice.selected, 0);
        for (const Candidate& candidate : choice.candidates) {
          EXPECT_FALSE(selectable.is_vetoed(candidate.pair));
          EXPECT_EQ(library().take_of(candidate.pair).name, "second");
          EXPECT_EQ(library().label(candidate.pair), "open_hold");
        }
        for (std::size_t b = 0; b < choice.intent.belief.size(); ++b)
          if (model()->blocks()[b].take == 0) {
            EXPECT_EQ(choice.intent.belief[b], 0) << "nothing is believed of it";
          }
      }
}

TEST_F(IntentSelectorTest, WithEverythingVetoedThereIsNothingToSelectOrBelieve) {
  selectable.set_vetoes({{}, {"first", "second"}, {}});
  current_pair = 20;
  const Choice choice = choose(first_leader(), 100);
  EXPECT_EQ(choice.selected, -1);
  EXPECT_TRUE(choice.candidates.empty());
  EXPECT_EQ(choice.intent.continued, -1);
  EXPECT_EQ(choice.intent.belief, std::vector<std::uint8_t>(model()->blocks().size(), 0));
  selectable.set_vetoes({});
  EXPECT_GE(choose(first_leader(), 100).selected, 0);
}

TEST_F(IntentSelectorTest, WhatIsNotMeantCostsMore) {
  weights.meant = 0.7;
  neighbours = 200;
  for (const IntendedPairs& meant :
       {IntendedPairs{"turn", {}}, IntendedPairs{{}, "second"}, IntendedPairs{"turn", "second"}}) {
    selectable.set_intended(meant);
    for (const Candidate& candidate : choose(stranger(), 100).candidates) {
      const bool is_meant = (!meant.label || library().label(candidate.pair) == *meant.label) &&
                            (!meant.take || library().take_of(candidate.pair).name == *meant.take);
      EXPECT_EQ(candidate.intent->meant, is_meant ? 0 : 0.7);
    }
  }
}

TEST_F(IntentSelectorTest, NamingATakeOrALabelMovesTheBeliefAndTheChoiceThere) {
  const auto belief_in = [&](const Choice& choice, std::uint32_t take) {
    int greatest = 0;
    for (std::size_t b = 0; b < choice.intent.belief.size(); ++b)
      if (model()->blocks()[b].take == take) greatest = std::max<int>(greatest, choice.intent.belief[b]);
    return greatest;
  };
  const Choice unnamed = choose(first_leader(), 120);
  EXPECT_EQ(library().take_of(unnamed.chosen().pair).name, "first");
  weights.meant = 2;
  selectable.set_intended(IntendedPairs{{}, "second"});
  const Choice named = choose(first_leader(), 120);
  EXPECT_EQ(library().take_of(named.chosen().pair).name, "second");
  EXPECT_EQ(belief_in(unnamed, 0), 255);
  EXPECT_EQ(belief_in(named, 1), 255);
  EXPECT_LT(belief_in(named, 0), 255);
  selectable.set_intended(IntendedPairs{"open_hold", {}});
  EXPECT_EQ(library().label(choose(first_leader(), 120).chosen().pair), "open_hold");
  weights.meant = 0;
  const Choice weightless = choose(first_leader(), 120);
  EXPECT_EQ(weightless.chosen().pair, unnamed.chosen().pair);
  EXPECT_EQ(weightless.chosen().intent->total, unnamed.chosen().intent->total);
  EXPECT_EQ(weightless.intent.belief, unnamed.intent.belief);
}

TEST_F(IntentSelectorTest, AnyPairCanBeJudgedLikeALanding) {
  const Choice choice = choose(stranger(), 90);
  for (const Candidate& candidate : choice.candidates) {
    const Candidate again =
        selector.candidate(candidate.pair, query_of(stranger()[90]), selectable, weights, true);
    EXPECT_NEAR(again.intent->total, candidate.intent->total, rounding_m);
    EXPECT_EQ(again.cost.total, candidate.cost.total);
  }
  current_pair = 3;
  const int between = pair("first", 91);
  const Candidate judged = selector.candidate(between, query_of(stranger()[90]), selectable, weights, true);
  EXPECT_EQ(judged.pair, between);
  EXPECT_EQ(judged.intent->change, weights.switch_margin);
}

TEST_F(IntentSelectorTest, KeepsNoStateBetweenFrames) {
  const Choice first = choose(first_leader(), 120);
  choose(stranger(), 30);
  const Choice again = choose(first_leader(), 120);
  EXPECT_EQ(again.selected, first.selected);
  EXPECT_EQ(again.intent.belief, first.intent.belief);
  for (std::size_t c = 0; c < first.candidates.size(); ++c)
    EXPECT_EQ(again.candidates.at(c).intent->total, first.candidates[c].intent->total);
}

}  // namespace
}  // namespace abrazo::intent_selector_test
