// The linear systems of real frames, answered by ours and the paper's way: one factorisation of the whole
// Lagrange system for every morph step. Same constraint rows, same regularisation, same refinement; the
// others are even told which rows bind, ours has to find out. An error when of 100 answers more than one
// differs by more than 1e-8 m, or any by more than 1e-6 m.
#include <benchmark/benchmark.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/base/statistics.hpp"
#include "tests/bench/bench_data.hpp"
#include "tests/bench/bench_main.hpp"
#include "tests/bench/dense_solver.hpp"
#include "tests/bench/recorded_frames.hpp"
#include "tests/bench/umfpack_solver.hpp"

namespace {

using namespace abrazo;
using namespace abrazo::bench;

constexpr double agreement_m = 1e-8;  ///< of 99 of 100 systems
constexpr double farthest_m = 1e-6;   ///< of every one
constexpr double step_rate_hz = 60;
constexpr std::size_t reference_every = 13;  ///< not a multiple of the systems in a frame

/// Selecting by Eq. 7: the selection `intent` would stand beside every solver and bring them nearer.
Settings settings() {
  Settings settings = *preset("responsive");
  settings.selection = SelectionMethod::Paper;
  return settings;
}

const RecordedFrames& recorded() {
  static const RecordedFrames frames = record_frames(bench_data(), settings(), step_rate_hz,
                                                     number_from_environment("ABRAZO_BENCH_FRAMES", 300));
  return frames;
}

/// The systems of each frame.
const std::vector<std::vector<KktSystem>>& systems() {
  static const auto all = [] {
    std::vector<std::vector<KktSystem>> frames;
    for (const FrameCalls& frame : recorded().frames) {
      auto& of_frame = frames.emplace_back();
      for (const FrameCalls::Call& call : frame.calls) of_frame.push_back(kkt_of(call.posed));
    }
    return frames;
  }();
  return all;
}

/// Asks the production solver what the frame asked it.
bool replay(const FrameCalls& frame, ConstrainedSolver& solver, std::vector<char>& active, PairPose& answer) {
  bool solved = true;
  for (const FrameCalls::Call& call : frame.calls) {
    if (call.new_energy) solved = solver.set_energy(frame.energy) && solved;
    solver.relax();
    for (const FrameCalls::Stiffened& s : call.stiffened) solver.stiffen(s.a, s.b, s.c);
    active = call.active;
    solved = (call.projects ? solver.project(call.linear, call.rows, active, answer)
                            : solver.solve(call.linear, call.rows, active, answer)) &&
             solved;
  }
  return solved;
}

double largest_difference_m(const std::vector<double>& solution, const PairPose& ours) {
  double largest_m = 0;
  for (int i = 0; i < KktSystem::unknowns; ++i)
    largest_m = std::max(largest_m, std::abs(solution[static_cast<std::size_t>(i)] - ours(i / 3, i % 3)));
  return largest_m;
}

/// How far somebody's answers are from ours [m].
struct Agreement {
  std::vector<double> differences_m;
  double unsolved = 0;
  double largest_m() const { return percentile(differences_m, 1); }
};
/// @param every  of so many systems one
Agreement agreement(KktSolver& solver, std::size_t every = 1) {
  Agreement found;
  std::vector<double> solution;
  std::size_t number = 0;
  for (std::size_t f = 0; f < systems().size(); ++f)
    for (std::size_t s = 0; s < systems()[f].size(); ++s) {
      if (number++ % every != 0) continue;
      if (solver.solve(systems()[f][s], solution))
        found.differences_m.push_back(
            largest_difference_m(solution, recorded().frames[f].calls[s].posed.answer));
      else
        ++found.unsolved;
    }
  return found;
}

void linear_ours(benchmark::State& state) {
  const auto& frames = recorded().frames;
  ConstrainedSolver solver;
  std::vector<char> active;
  PairPose answer;
  std::size_t at = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(replay(frames[at], solver, active, answer));
    if (++at == frames.size()) at = 0;
  }
  double calls = 0, rows = 0;
  for (const FrameCalls& frame : frames)
    for (const FrameCalls::Call& call : frame.calls) {
      ++calls;
      rows += static_cast<double>(call.posed.binding.size());
    }
  static const Agreement exact = agreement(*reference_solver(), reference_every);
  state.counters["largest_error_m"] = exact.largest_m();
  state.counters["p99_error_m"] = percentile(exact.differences_m, 0.99);
  state.counters["systems"] = calls / static_cast<double>(frames.size());
  state.counters["rows"] = rows / calls;
}

template <typename Make>
void linear_other(benchmark::State& state, const Make& make) {
  const auto& all = systems();
  const auto solver = make();
  std::vector<double> solution;
  std::size_t at = 0;
  for (auto _ : state) {
    for (const KktSystem& system : all[at]) benchmark::DoNotOptimize(solver->solve(system, solution));
    if (++at == all.size()) at = 0;
  }
  static std::optional<Agreement> known;  // one for each `Make`
  if (!known) known = agreement(*solver);
  state.counters["largest_difference_m"] = known->largest_m();
  state.counters["p99_difference_m"] = percentile(known->differences_m, 0.99);
  state.counters["unsolved"] = known->unsolved;
  double entries = 0, size = 0, count = 0;
  for (const auto& frame : all)
    for (const KktSystem& system : frame) {
      entries += static_cast<double>(system.values.size());
      size += system.size;
      ++count;
    }
  state.counters["size"] = size / count;
  state.counters["entries"] = entries / count;
  if (known->unsolved > 0 || known->largest_m() > farthest_m ||
      percentile(known->differences_m, 0.99) > agreement_m)
    state.SkipWithError(
        fmt::format("{} systems unsolved, answers differ by {:.1e} m", known->unsolved, known->largest_m())
            .c_str());
}

/// Whole steps of the production pipeline over the same frames.
void whole_ours(benchmark::State& state) {
  WholeSteps steps(bench_data(), settings(), step_rate_hz, static_cast<int>(recorded().frames.size()));
  for (auto _ : state) steps.next();
}

void linear_umfpack(benchmark::State& state) {
  linear_other(state, [] { return umfpack_solver(Ordering::Each); });
}
void linear_umfpack_reused(benchmark::State& state) {
  linear_other(state, [] { return umfpack_solver(Ordering::Reused); });
}
void linear_dense(benchmark::State& state) {
  linear_other(state, [] { return dense_solver(Pivoting::Partial); });
}
void linear_dense_full(benchmark::State& state) {
  linear_other(state, [] { return dense_solver(Pivoting::Full); });
}

BENCHMARK(whole_ours)->Name("whole/ours")->Unit(benchmark::kMicrosecond);
BENCHMARK(linear_ours)->Name("linear/ours")->Unit(benchmark::kMicrosecond);
BENCHMARK(linear_umfpack)->Name("linear/umfpack")->Unit(benchmark::kMicrosecond);
BENCHMARK(linear_umfpack_reused)->Name("linear/umfpack, ordering reused")->Unit(benchmark::kMicrosecond);
BENCHMARK(linear_dense)->Name("linear/dense LU, partial pivoting")->Unit(benchmark::kMicrosecond);
BENCHMARK(linear_dense_full)->Name("linear/dense LU, full pivoting")->Unit(benchmark::kMicrosecond);

}  // namespace

int main(int argc, char** argv) {
  benchmark::AddCustomContext("umfpack", umfpack_version());
  return run_benchmarks(argc, argv);
}
