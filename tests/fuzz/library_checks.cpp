#include "tests/fuzz/library_checks.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>

#include "core/library/store/library_checks.hpp"
#include "core/selection/pair_selector.hpp"
#include "tests/fuzz/fuzz_target.hpp"

namespace abrazo::fuzz {

namespace {

/// A compressed file may hold many: these are enough.
constexpr int most_pairs = 2000, most_queries = 8;

bool is_body(const LibraryBody& body) {
  return std::all_of(body.body.bone_lengths.begin(), body.body.bone_lengths.end(),
                     [](double length) { return std::isfinite(length) && length >= 0; }) &&
         std::isfinite(body.body.height());
}

void expect_pair(const MotionLibrary& library, int pair) {
  expect(library.pose(pair).allFinite(), "a pose is not finite");
  expect(library.features(pair).allFinite(), "features are not finite");
  expect(library.root(pair).position.allFinite() && std::isfinite(library.root(pair).heading_rad),
         "a root is not finite");
  expect(is_in_order(library.edges(pair)), "edges are out of order or out of range");
  expect(names_vertices(library.tetrahedra(pair)), "a tetrahedron of vertices that there are not");
  const PairSource& source = library.source(pair);
  const LibraryTake& take = library.take_of(pair);
  expect(static_cast<int>(source.frame) < take.frames && std::isfinite(take.fps) && take.fps > 0,
         "a frame that its take has not, or a take without a rate");
  expect(is_body(library.active_body(pair)) && is_body(library.passive_body(pair)), "a body that is none");
  (void)library.label(pair);
  for (const int steps : {-1, 1, 1'000'000'000}) {
    const int later = library.later_pair(pair, steps);
    expect(later == -1 || (later >= 0 && later < library.pair_count()), "a later pair that is not there");
  }
  if (library.find_take(take.name) == static_cast<int>(source.take))
    expect(library.find_pair(take.name, static_cast<int>(source.frame), source.swapped) == pair,
           "a pair that is not found by its frame");
}

void expect_neighbours(const MotionLibrary& library, PairSelector& selector, int pair) {
  SelectionQuery query;
  query.normalized = library.pose(pair).topRows<joint_count>();
  query.features = library.features(pair);
  query.has_prediction = true;
  query.predicted = library.pair_in_world(pair, query.root);
  query.current_pair = pair;
  query.continuations = 2;
  std::vector<Candidate> candidates;
  const int best = selector.select(query, candidates);
  expect(best >= 0 && static_cast<std::size_t>(best) < candidates.size(), "nothing is near a pair itself");
  double before = 0;
  for (const Candidate& candidate : candidates) {
    expect(candidate.pair >= 0 && candidate.pair < library.pair_count(), "a candidate that is not there");
    expect(std::isfinite(candidate.feature_distance) && candidate.feature_distance >= before,
           "candidates are not in the order of their distance");
    before = candidate.feature_distance;
    expect(std::isfinite(candidate.cost.total) && candidate.cost.total >= 0, "a cost that is none");
    expect(candidate.cost.total >= candidates[static_cast<std::size_t>(best)].cost.total,
           "the selected pair is not the cheapest");
  }
  expect(candidates.front().feature_distance == 0, "a pair is not the nearest to itself");
}

}  // namespace

void expect_usable(const MotionLibrary& library) {
  expect(library.pair_count() > 0, "a library without pairs was accepted");
  const int pairs = std::min(library.pair_count(), most_pairs);
  for (int pair = 0; pair < pairs; ++pair) expect_pair(library, pair);
  std::vector<int> all(static_cast<std::size_t>(library.pair_count()));
  std::iota(all.begin(), all.end(), 0);
  PairSelector selector(std::shared_ptr<const MotionLibrary>(std::shared_ptr<void>(), &library),
                        std::move(all));
  for (int pair = 0; pair < pairs; pair += 1 + pairs / most_queries)
    expect_neighbours(library, selector, pair);
  const auto damage = library.damage();
  if (damage) expect_readable(*damage);
  for (int pair = 0; pair < pairs; ++pair)
    expect(damage || is_within_reach(library.columns().poses[static_cast<std::size_t>(pair)]),
           "a damaged pair was passed over without a word");
  const MotionLibrary exchanged = with_roles_exchanged(library);
  for (int pair = 0; pair < pairs; ++pair) expect_pair(exchanged, pair);
  expect(exchanged.damage().has_value() == damage.has_value(), "damage is lost where roles are exchanged");
}

}  // namespace abrazo::fuzz
