#include "tests/bench/bench_data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>

#include "core/choreography/salsa.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "core/library/store/takes_of_library.hpp"

namespace abrazo::bench {

namespace {

constexpr double generated_hz = 60;
constexpr int usual_pairs = 43'000;
constexpr int user_frames = 2'400;
constexpr std::uint64_t library_couple = 1;
constexpr std::uint64_t other_couple = 77;

[[noreturn]] void stop(const std::string& why) {
  fmt::print(stderr, "{}\n", why);
  std::exit(1);
}

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

MotionLibrary library_to_measure() {
  if (const char* file = environment("ABRAZO_BENCH_LIBRARY")) {
    auto library = read_library(file);
    if (!library) stop(library.error().text());
    return std::move(*library);
  }
  const int pairs = number_from_environment("ABRAZO_BENCH_PAIRS", usual_pairs);
  auto library = build_library("generated salsa", generated_takes(library_couple, pairs), {}, {});
  if (!library) stop(library.error().text());
  return std::move(*library);
}

BenchData make() {
  BenchData data;
  data.library = std::make_shared<const MotionLibrary>(library_to_measure());
  const char* held_out = environment("ABRAZO_BENCH_HELD_OUT");
  if (held_out == nullptr) {
    data.user = generated_takes(other_couple, user_frames).front().a;
    return data;
  }
  const auto takes = takes_of_library(*data.library);
  if (!takes) stop(takes.error().text());
  const auto take = std::find_if(takes->begin(), takes->end(),
                                 [held_out](const PairedTake& t) { return t.name == held_out; });
  if (take == takes->end()) stop(fmt::format("the library has no take '{}' to hold out", held_out));
  data.user = take->a;
  data.excluded = {take->name};
  return data;
}

}  // namespace

const BenchData& bench_data() {
  static const BenchData data = make();
  return data;
}

int number_from_environment(const char* name, int otherwise) {
  const char* text = environment(name);
  if (text == nullptr) return otherwise;
  int number = 0;
  const char* end = text + std::strlen(text);
  if (const auto [rest, error] = std::from_chars(text, end, number);
      error != std::errc() || rest != end || number < 1)
    stop(fmt::format("{} is '{}'; expected a whole number above 0", name, text));
  return number;
}

std::vector<PairedTake> generated_takes(std::uint64_t seed, int frames) {
  ChoreographyOptions options;
  options.seed = seed;
  options.minutes = frames / generated_hz / 60;
  options.fps = generated_hz;
  options.take_seconds = std::min(60.0, frames / generated_hz);
  if (seed != library_couple) {
    options.a.height_m = 1.74;
    options.b.height_m = 1.62;
  }
  return generate_salsa(options);
}

std::vector<PairPose> spread_pairs(const MotionLibrary& library, int count) {
  const int pairs = std::min(count, library.pair_count());
  std::vector<PairPose> poses;
  poses.reserve(static_cast<std::size_t>(pairs));
  for (long long i = 0; i < pairs; ++i)
    poses.push_back(library.pose(static_cast<int>(i * library.pair_count() / pairs)));
  return poses;
}

}  // namespace abrazo::bench
