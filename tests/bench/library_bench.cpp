// Building a library on one core and on all, and reading it back, beside what the bytes of its file take
// alone.
#include <benchmark/benchmark.h>
#include <fmt/core.h>
#include <sched.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/library/build/motion_library_builder.hpp"
#include "core/library/store/motion_library_file.hpp"
#include "tests/bench/bench_data.hpp"
#include "tests/bench/bench_main.hpp"

namespace {

using namespace abrazo;
using namespace abrazo::bench;

/// The calling thread, and threads that it starts, stay on one core while this lives.
class OneCore {
 public:
  OneCore() {
    sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(sched_getcpu(), &one);
    sched_setaffinity(0, sizeof one, &one);
  }
  ~OneCore() { sched_setaffinity(0, sizeof before_, &before_); }
  OneCore(const OneCore&) = delete;
  OneCore& operator=(const OneCore&) = delete;

 private:
  cpu_set_t before_{};
};

const char* manifest_file() {
  const char* file = std::getenv("ABRAZO_BENCH_MANIFEST");
  return file != nullptr && *file != '\0' ? file : nullptr;
}

/// From the text files of a manifest, or from takes that are in memory where there is none.
Result<MotionLibrary> build() {
  if (manifest_file() == nullptr) {
    static const auto takes = generated_takes(1, number_from_environment("ABRAZO_BENCH_PAIRS", 43'000));
    return build_library("generated", takes, {}, {});
  }
  const auto manifest = read_manifest(manifest_file());
  if (!manifest) return manifest.error();
  std::vector<std::string> warnings;
  return build_library(*manifest, {}, {}, warnings);
}

/// The file that is read: ABRAZO_BENCH_LIBRARY, else what is built, written once.
const std::filesystem::path& file() {
  static const auto path = []() -> std::filesystem::path {
    const char* given = std::getenv("ABRAZO_BENCH_LIBRARY");
    if (given != nullptr && *given != '\0') return given;
    const auto made = std::filesystem::temp_directory_path() / "abrazo_bench_library.h5";
    if (const Status written = write_library(*bench_data().library, made); !written)
      fmt::print(stderr, "{}\n", written.error().text());
    return made;
  }();
  return path;
}

template <typename T>
bool same_bytes(const T& a, const T& b) {
  const auto bytes = [](const T& column) { return std::as_bytes(std::span(column.data(), column.size())); };
  return std::ranges::equal(bytes(a), bytes(b));
}

/// What is computed, to the bit.
bool same(const MotionLibrary& a, const MotionLibrary& b) {
  const LibraryColumns &x = a.columns(), &y = b.columns();
  return same_bytes(x.poses, y.poses) && same_bytes(x.features, y.features) && same_bytes(x.edges, y.edges) &&
         same_bytes(x.tetrahedra, y.tetrahedra);
}

void build_on(benchmark::State& state, bool on_one_core) {
  static std::optional<MotionLibrary> before;
  std::optional<OneCore> one;
  if (on_one_core) one.emplace();
  for (auto _ : state) {
    auto built = build();
    if (!built) return state.SkipWithError(built.error().text().c_str());
    state.PauseTiming();
    if (before && !same(*before, *built)) return state.SkipWithError("another library than before");
    before = std::move(*built);
    state.ResumeTiming();
  }
  state.counters["pairs"] = before->pair_count();
  state.SetLabel(manifest_file() == nullptr ? "from memory" : "from text files");
}

void load(benchmark::State& state, const LibraryReading& reading) {
  int pairs = 0;
  for (auto _ : state) {
    const auto library = read_library(file(), reading);
    if (!library) return state.SkipWithError(library.error().text().c_str());
    pairs = library->pair_count();
  }
  state.counters["pairs"] = pairs;
}

/// The least that reading into memory can cost.
void read_bytes(benchmark::State& state) {
  const auto size = static_cast<std::streamsize>(std::filesystem::file_size(file()));
  for (auto _ : state) {
    std::vector<char> bytes(static_cast<std::size_t>(size));
    std::ifstream(file(), std::ios::binary).read(bytes.data(), size);
    benchmark::DoNotOptimize(bytes.data());
  }
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * size);
}

void add(const char* name, void (*body)(benchmark::State&)) {
  benchmark::RegisterBenchmark(name, body)
      ->Iterations(1)
      ->MeasureProcessCPUTime()
      ->UseRealTime()
      ->Unit(benchmark::kMillisecond);
}

}  // namespace

int main(int argc, char** argv) {
  add("library/build/one core", [](benchmark::State& state) { build_on(state, true); });
  add("library/build/all cores", [](benchmark::State& state) { build_on(state, false); });
  add("library/load", [](benchmark::State& state) { load(state, {}); });
  add("library/load, mapped", [](benchmark::State& state) { load(state, {.largest_in_memory_bytes = 0}); });
  add("library/read bytes", read_bytes);
  return run_benchmarks(argc, argv);
}
