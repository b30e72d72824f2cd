#include "tests/bench/many_features.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>

#include "core/choreography/salsa.hpp"
#include "core/evaluation/takes/pose_queries.hpp"
#include "core/retarget/body_retargeter.hpp"

namespace abrazo::bench {

namespace {

Features features_of(const Pose& pose) {
  return pose_features(to_normalized(pose, root_frame(pose)));
}

void add_library(const BenchData& data, std::vector<Features>& features) {
  auto pairs = pairs_without(*data.library, data.excluded.empty() ? std::string() : data.excluded.front(), 0);
  std::mt19937_64 random(1);
  for (std::size_t i = pairs.size(); i > 1; --i) std::swap(pairs[i - 1], pairs[random() % i]);
  for (const int pair : pairs) features.push_back(data.library->features(pair));
}

void add_dances(std::size_t count, std::vector<Features>& features) {
  for (std::uint64_t seed = 1000; features.size() < count; ++seed) {
    ChoreographyOptions options;
    options.seed = seed;
    options.minutes = 5;
    options.a.height_m = 1.65 + 0.02 * static_cast<double>(seed % 13);
    options.b.height_m = 1.55 + 0.02 * static_cast<double>(seed % 11);
    for (const PairedTake& take : generate_salsa(options))
      for (const Pose& pose : take.a.poses)
        if (features.size() < count) features.push_back(features_of(pose));
  }
}

/// Those there are, on bodies that are up to a tenth smaller or larger, each coordinate off by a centimetre.
void add_other_bodies(std::size_t count, std::vector<Features>& features) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> size(0.9, 1.1);
  std::normal_distribution<double> metres(0, 0.01);
  const std::size_t recorded = features.size();
  double body = 1;
  for (std::size_t i = 0; features.size() < count; ++i) {
    if (i % recorded == 0) body = size(random);
    Features other = body * features[i % recorded];
    for (double& coordinate : other) coordinate += metres(random);
    features.push_back(other);
  }
}

const char* kept_in() {
  const char* file = std::getenv("ABRAZO_BENCH_FEATURES");
  return file != nullptr && *file != '\0' ? file : nullptr;
}

std::streamsize bytes(std::size_t count) {
  return static_cast<std::streamsize>(count * sizeof(Features));
}

bool read_kept(std::vector<Features>& features, std::size_t count) {
  if (kept_in() == nullptr) return false;
  std::ifstream file(kept_in(), std::ios::binary);
  features.resize(count);
  return file.read(reinterpret_cast<char*>(features.data()), bytes(count)).good();
}

}  // namespace

std::vector<Features> many_features(const BenchData& data, std::size_t count) {
  std::vector<Features> features;
  if (read_kept(features, count)) return features;
  features.clear();
  add_library(data, features);
  if (data.excluded.empty())
    add_dances(count, features);
  else
    add_other_bodies(count, features);
  features.resize(count);
  if (kept_in() != nullptr)
    std::ofstream(kept_in(), std::ios::binary)
        .write(reinterpret_cast<const char*>(features.data()), bytes(count));
  return features;
}

std::vector<Features> user_features(const BenchData& data, int count) {
  const BodyRetargeter retargeter(body_of(data.user.poses), data.library->usual_active_body().body);
  std::vector<Features> features;
  const auto frames = static_cast<int>(data.user.poses.size());
  for (int i = 0; i < std::min(count, frames); ++i) {
    const auto frame = static_cast<std::size_t>(frames / std::min(count, frames) * i);
    features.push_back(features_of(retargeter.apply(data.user.poses[frame])));
  }
  return features;
}

}  // namespace abrazo::bench
