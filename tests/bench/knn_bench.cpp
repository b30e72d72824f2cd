// The nearest poses: our index (FLANN's tree narrows the search, as for libraries in memory) and our own tree
// (as for mapped ones) against every distance computed and against nanoflann, the same answers. Skips what
// does not agree. `knn` is the mean over poses of the user; `query` has the median and the slowest hundredth
// of poses that are so many centimetres off on every coordinate, with the answer to the frame before at hand
// and without.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>

#include "core/library/store/pose_index.hpp"
#include "tests/bench/bench_main.hpp"
#include "tests/bench/knn_others.hpp"
#include "tests/bench/many_features.hpp"

namespace {

using namespace abrazo;
using namespace abrazo::bench;

constexpr std::array sizes = {7'500, 43'000, 100'000, 300'000, 1'000'000};
constexpr std::array counts = {10, 50};
constexpr std::array off_cm = {0, 10, 30, 60};
constexpr std::array leaf_sizes = {8, 12, 16, 24, 32, 48};
constexpr int query_count = 200;
constexpr int frame_count = 2000;
constexpr double agreement_m = 1e-8;
constexpr double single_agreement_m = 1e-5;

int largest() {
  return number_from_environment("ABRAZO_BENCH_LARGEST", sizes.back());
}

const std::vector<Features>& all_features() {
  static const auto features = many_features(bench_data(), static_cast<std::size_t>(largest()));
  return features;
}

std::span<const Features> first(int size) {
  return std::span(all_features()).first(static_cast<std::size_t>(size));
}

std::span<const double> numbers(std::span<const Features> features) {
  static_assert(sizeof(Features) == feature_count * sizeof(double));
  return {features.front().data(), features.size() * feature_count};
}

const std::vector<Features>& queries() {
  static const auto all = user_features(bench_data(), query_count);
  return all;
}

/// What is made for a size is kept while benchmarks of that size run: one size at a time in memory.
template <typename Thing, typename Make>
Thing& kept(int size, const Make& make) {
  static std::optional<std::pair<int, Thing>> current;
  if (!current || current->first != size) {
    current.reset();
    current.emplace(size, make());
  }
  return current->second;
}

const PoseIndex& index_of(int size, PoseIndex::Tree tree = PoseIndex::Tree::Flann) {
  static std::map<std::pair<int, PoseIndex::Tree>, PoseIndex> made;
  const auto at = made.find({size, tree});
  if (at != made.end()) return at->second;
  std::vector<int> pairs(static_cast<std::size_t>(size));
  std::iota(pairs.begin(), pairs.end(), 0);
  return made.emplace(std::pair(size, tree), PoseIndex(first(size), pairs, tree)).first->second;
}

/// Largest difference of a neighbour's distance to ours over all queries [m].
double difference(OtherSearch& search, int size, int count) {
  double largest_m = 0;
  std::vector<PoseMatch> ours;
  std::vector<Neighbour> found;
  for (const Features& query : queries()) {
    ours.clear();
    index_of(size).nearest(query, count, ours);
    search.nearest(query.data(), count, found);
    if (found.size() != ours.size()) return std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ours.size(); ++i)
      largest_m = std::max(largest_m, std::abs(std::sqrt(found[i].square) - ours[i].distance));
  }
  return largest_m;
}

void run_ours(benchmark::State& state, int size, int count, PoseIndex::Tree tree) {
  const PoseIndex& index = index_of(size, tree);
  std::vector<PoseMatch> found;
  std::size_t at = 0;
  for (auto _ : state) {
    found.clear();  // as if nothing had been asked before
    index.nearest(queries()[at], count, found);
    benchmark::DoNotOptimize(found.data());
    if (++at == queries().size()) at = 0;
  }
}

void run_other(benchmark::State& state, OtherSearch& search, int size, int count, double allowed_m) {
  std::vector<Neighbour> found;
  std::size_t at = 0;
  for (auto _ : state) {
    search.nearest(queries()[at].data(), count, found);
    benchmark::DoNotOptimize(found.data());
    if (++at == queries().size()) at = 0;
  }
  static std::map<std::tuple<OtherSearch*, int>, double> known;
  const auto key = std::tuple(&search, count);
  if (!known.contains(key)) known[key] = difference(search, size, count);
  state.counters["largest_difference_m"] = known[key];
  if (!(known[key] <= allowed_m))
    state.SkipWithError(fmt::format("distances differ by {:.1e} m", known[key]).c_str());
}

OtherSearch& double_brute(int size) {
  static std::map<int, std::unique_ptr<OtherSearch>> made;
  auto& search = made[size];
  if (!search) search = brute_force_double(numbers(first(size)));
  return *search;
}

OtherSearch& single_brute(int size) {
  static std::map<int, std::unique_ptr<OtherSearch>> made;
  auto& search = made[size];
  if (!search) search = brute_force_single(numbers(first(size)));
  return *search;
}

double seconds_for_queries(OtherSearch& search) {
  std::vector<Neighbour> found;
  const auto begin = std::chrono::steady_clock::now();
  for (const Features& query : queries()) search.nearest(query.data(), counts.front(), found);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// nanoflann at its best: the leaf size that answers fastest at this size.
struct Tuned {
  std::unique_ptr<OtherSearch> search;
  int leaf_size = 0;
};
Tuned& tuned_nanoflann(int size) {
  static std::map<int, Tuned> made;
  Tuned& best = made[size];
  if (best.search) return best;
  double least_s = std::numeric_limits<double>::infinity();
  for (const int leaf_size : leaf_sizes) {
    auto search = nanoflann_search(numbers(first(size)), leaf_size);
    seconds_for_queries(*search);  // warms the caches
    const double seconds = std::min(seconds_for_queries(*search), seconds_for_queries(*search));
    if (seconds >= least_s) continue;
    least_s = seconds;
    best = {std::move(search), leaf_size};
  }
  return best;
}

double thread_us() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

/// Each frame of the user, off by as much as wanted, after the frame before with the same error.
/// @param ask  asked for both; only the second is timed
void run_frames(benchmark::State& state, int off, const std::function<void(const Features&, bool)>& ask) {
  static const auto frames = user_features(bench_data(), frame_count);
  std::vector<double> took_us;
  for (auto _ : state) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> metres(0, 0.01 * off);
    for (std::size_t i = 1; i < frames.size(); i += 4) {
      Features error = Features::Zero();
      if (off > 0)
        for (double& coordinate : error) coordinate = metres(random);
      ask(frames[i - 1] + error, false);
      const double begin_us = thread_us();
      ask(frames[i] + error, true);
      took_us.push_back(thread_us() - begin_us);
    }
  }
  std::sort(took_us.begin(), took_us.end());
  state.counters["p50_us"] = took_us[took_us.size() / 2];
  state.counters["p99_us"] = took_us[took_us.size() * 99 / 100];
}

void register_frames(int size, int off) {
  const auto add = [&](const char* who, auto asked) {
    benchmark::RegisterBenchmark(fmt::format("query/{}/{}/{} cm", who, size, off).c_str(),
                                 [=](benchmark::State& state) { run_frames(state, off, asked()); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  };
  const auto add_index = [&](const char* who, PoseIndex::Tree tree, bool continues) {
    add(who, [=] {
      return [=, &index = index_of(size, tree), matches = std::vector<PoseMatch>()](const Features& query,
                                                                                    bool is_second) mutable {
        if (is_second && !continues) matches.clear();
        index.nearest(query, counts.front(), matches);
      };
    });
  };
  add_index("FLANN", PoseIndex::Tree::Flann, false);
  add_index("FLANN, after the frame before", PoseIndex::Tree::Flann, true);
  add_index("own tree", PoseIndex::Tree::Own, false);
  add_index("own tree, after the frame before", PoseIndex::Tree::Own, true);
  const auto add_other = [&](const char* who, auto search_of) {
    add(who, [=] {
      return
          [&search = search_of(size), found = std::vector<Neighbour>()](const Features& query, bool) mutable {
            search.nearest(query.data(), counts.front(), found);
          };
    });
  };
  add_other("nanoflann", [](int rows) -> OtherSearch& { return *tuned_nanoflann(rows).search; });
  add_other("every distance, single", [](int rows) -> OtherSearch& { return single_brute(rows); });
  add_other("every distance, double", [](int rows) -> OtherSearch& { return double_brute(rows); });
}

void register_size(int size) {
  for (const int off : off_cm) register_frames(size, off);
  for (const int count : counts) {
    const auto name = [&](const char* who) { return fmt::format("knn/{}/{}/{}", who, size, count); };
    const auto add = [&](const char* who, auto body) {
      benchmark::RegisterBenchmark(name(who).c_str(), body)->Unit(benchmark::kMicrosecond);
    };
    add("ours", [=](benchmark::State& state) { run_ours(state, size, count, PoseIndex::Tree::Flann); });
    add("own tree", [=](benchmark::State& state) { run_ours(state, size, count, PoseIndex::Tree::Own); });
    add("brute double", [=](benchmark::State& state) {
      run_other(state, double_brute(size), size, count, agreement_m);
      // What has to be read from memory at least.
      state.SetBytesProcessed(state.iterations() * size * feature_count * 8);
    });
    add("brute single", [=](benchmark::State& state) {
      run_other(state, single_brute(size), size, count, single_agreement_m);
      state.SetBytesProcessed(state.iterations() * size * feature_count * 4);
    });
    add("nanoflann", [=](benchmark::State& state) {
      run_other(state, *tuned_nanoflann(size).search, size, count, agreement_m);
      state.counters["leaf_size"] = tuned_nanoflann(size).leaf_size;
    });
  }
}

}  // namespace

int main(int argc, char** argv) {
  for (const int size : sizes)
    if (size <= largest()) register_size(size);
  return run_benchmarks(argc, argv);
}
