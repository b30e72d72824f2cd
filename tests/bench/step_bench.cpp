// One whole step, every one timed by itself: percentiles, and where the time goes.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>

#include "core/base/statistics.hpp"
#include "core/motion/body/resample.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "tests/bench/bench_data.hpp"
#include "tests/bench/bench_main.hpp"

namespace {

using namespace abrazo;
using namespace abrazo::bench;

constexpr int warm_up_steps = 60;

/// The user's poses at a rate, those in between on straight lines.
std::vector<Pose> user_at_rate(double rate_hz) {
  const Clip& user = bench_data().user;
  std::vector<StampedPose> stamped;
  for (std::size_t i = 0; i < user.poses.size(); ++i)
    stamped.push_back({static_cast<double>(i) / user.fps, user.poses[i]});
  return resample(stamped, rate_hz).poses;
}

/// Processor time of this thread: unlike the clock it does not count what the machine did meanwhile.
double thread_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

struct Steps {
  std::vector<double> clock_us, thread_us, retarget_us, select_us, mesh_us, solve_us;
  double not_ok = 0;
  void add(const FrameResult& result, double clock, double thread) {
    clock_us.push_back(clock);
    thread_us.push_back(thread);
    retarget_us.push_back(result.timing.retarget_us);
    select_us.push_back(result.timing.select_us);
    mesh_us.push_back(result.timing.mesh_us);
    solve_us.push_back(result.timing.solve_us);
    not_ok += result.status != StepStatus::Ok;
  }
};

void report(benchmark::State& state, const Steps& steps) {
  state.counters["p50_us"] = percentile(steps.clock_us, 0.5);
  state.counters["p95_us"] = percentile(steps.clock_us, 0.95);
  state.counters["p99_us"] = percentile(steps.clock_us, 0.99);
  state.counters["max_us"] = percentile(steps.clock_us, 1);
  state.counters["thread_p50_us"] = percentile(steps.thread_us, 0.5);
  state.counters["thread_p99_us"] = percentile(steps.thread_us, 0.99);
  state.counters["retarget_us"] = percentile(steps.retarget_us, 0.5);
  state.counters["select_us"] = percentile(steps.select_us, 0.5);
  state.counters["mesh_us"] = percentile(steps.mesh_us, 0.5);
  state.counters["solve_us"] = percentile(steps.solve_us, 0.5);
  state.counters["steps"] = static_cast<double>(steps.clock_us.size());
  state.counters["not_ok"] = steps.not_ok;
  state.counters["pairs"] = bench_data().library->pair_count();
}

/// What else runs on a machine between two frames of a live session takes the caches: this much is written
/// between two steps, several times a core's own.
class OtherWork {
 public:
  explicit OtherWork(bool is_there) : bytes_(is_there ? std::size_t{64} << 20 : 0) {}
  void run() {
    for (std::size_t at = 0; at < bytes_.size(); at += 64) ++bytes_[at];
    benchmark::ClobberMemory();
  }

 private:
  std::vector<unsigned char> bytes_;
};

enum class Caches { Warm, Cold };

/// One iteration is one run over the user's clip, at most `ABRAZO_BENCH_FRAMES` steps.
void run(benchmark::State& state, const Settings& settings, double rate_hz, Caches caches) {
  const auto poses = user_at_rate(rate_hz);
  const auto most = static_cast<std::size_t>(number_from_environment("ABRAZO_BENCH_FRAMES", 1200));
  auto synthesizer = PartnerSynthesizer::create(bench_data().library, settings, bench_data().excluded);
  if (!synthesizer) return state.SkipWithError(synthesizer.error().text().c_str());
  (*synthesizer)->set_user_body(body_of(bench_data().user.poses));
  OtherWork other(caches == Caches::Cold);
  Steps steps;
  for (auto _ : state) {
    (*synthesizer)->reset();
    double total_s = 0;
    for (std::size_t i = 0; i < std::min(poses.size(), most + warm_up_steps); ++i) {
      other.run();
      const double thread_begin = thread_us();
      const auto begin = std::chrono::steady_clock::now();
      const FrameResult& result = (*synthesizer)->step(poses[i], Duration(1 / rate_hz));
      const std::chrono::duration<double> clock = std::chrono::steady_clock::now() - begin;
      const double thread = thread_us() - thread_begin;
      if (i < warm_up_steps) continue;
      total_s += clock.count();
      steps.add(result, 1e6 * clock.count(), thread);
    }
    state.SetIterationTime(total_s);
  }
  report(state, steps);
}

}  // namespace

int main(int argc, char** argv) {
  Settings by_pose = *preset("responsive");
  by_pose.selection = SelectionMethod::Paper;
  const std::array<std::pair<std::string_view, Settings>, 3> runs = {
      {{"paper", *preset("paper")}, {"responsive", *preset("responsive")}, {"responsive by Eq. 7", by_pose}}};
  const auto add = [](const std::string& name, const Settings& settings, double rate_hz, Caches caches) {
    benchmark::RegisterBenchmark(
        name.c_str(),
        [settings, rate_hz, caches](benchmark::State& state) { run(state, settings, rate_hz, caches); })
        ->UseManualTime()
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  };
  for (const auto& [name, settings] : runs)
    for (const int rate_hz : {15, 60, 120})
      add(fmt::format("step/{}/{} Hz", name, rate_hz), settings, rate_hz, Caches::Warm);
  add("step/responsive/60 Hz, cold caches", *preset("responsive"), 60, Caches::Cold);
  Settings other_bodies = *preset("responsive");
  other_bodies.active_body.kind = BodyChoice::Kind::User;
  other_bodies.passive_body = *parse_body_choice("scale:0.85");
  add("step/responsive/60 Hz, bodies user and 0.85", other_bodies, 60, Caches::Warm);
  return run_benchmarks(argc, argv);
}
