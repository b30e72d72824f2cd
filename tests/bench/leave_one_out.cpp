// abrazo_leave_one_out MANIFEST TAKE[,TAKE...] SPEC...
// Every take answered from the other takes of the manifest, leader in, partner compared with the recorded
// one. A SPEC is a preset with changed settings: "responsive,alpha=0.5,step-rate=15". One line per SPEC.
#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "core/base/statistics.hpp"
#include "core/base/text.hpp"
#include "core/library/build/motion_library_builder.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/metrics/run_summary.hpp"
#include "core/synthesis/step/clip_synthesis.hpp"

namespace {

using namespace abrazo;

struct Totals {
  std::vector<double> errors_m, speeds_m_s, step_us, excess_m;
  double hold_sum_m = 0;
  std::size_t holds = 0, changes = 0, relaxed = 0, failed = 0;
  double seconds = 0;
};

Result<Settings> parse_spec(std::string_view spec) {
  const auto words = split_fields(spec, ',');
  auto settings = preset(words.front());
  for (std::size_t w = 1; settings && w < words.size(); ++w) {
    const auto pair = split_fields(words[w], '=');
    if (pair.size() != 2) return Error{"expected KEY=VALUE", std::string(words[w])};
    if (const Status set = set_setting(*settings, pair[0], pair[1]); !set) return set.error();
  }
  return settings;
}

Status run_take(const PairedTake& take, const std::shared_ptr<const MotionLibrary>& library,
                const Settings& settings, Totals& totals) {
  auto synthesizer = PartnerSynthesizer::create(library, settings, {take.name});
  if (!synthesizer) return synthesizer.error();
  RunSummary summary(*library);
  Pose previous = Pose::Zero();
  double previous_s = -1;
  const Status done = synthesize_clip(
      **synthesizer, take.a,
      [&](const ClipStep& step) -> Status {
        summary.add(step.result, step.time_s);
        totals.step_us.push_back(step.result.timing.total_us);
        if (step.result.status == StepStatus::Failed) return Done{};
        const Pose partner = step.result.passive();
        totals.errors_m.push_back(
            (partner - take.b.poses[static_cast<std::size_t>(step.input_frame)]).rowwise().norm().mean());
        totals.excess_m.push_back(step.result.residual.excess_penetration_max_m);
        totals.changes += step.result.source_changed;
        if (previous_s >= 0)
          totals.speeds_m_s.push_back((partner - previous).rowwise().norm().mean() /
                                      (step.time_s - previous_s));
        previous = partner;
        previous_s = step.time_s;
        return Done{};
      },
      {});
  const RunSummary::Figures figures = summary.figures();
  totals.hold_sum_m += figures.hold_change_mean_m * static_cast<double>(figures.holds);
  totals.holds += figures.holds;
  totals.relaxed += figures.relaxed;
  totals.failed += figures.failed;
  totals.seconds += take.a.duration_s();
  return done;
}

void print(std::string_view spec, const Totals& t) {
  const double mean_error =
      std::accumulate(t.errors_m.begin(), t.errors_m.end(), 0.0) / static_cast<double>(t.errors_m.size());
  fmt::print(
      "{:<60} partner error mean {:.3f} median {:.3f} m | holds {:.1f} mm of {} | changes/s {:.2f} per 100 "
      "{:.1f} | speed p99 "
      "{:.2f} m/s | excess p99 {:.1f} mm | relaxed {} failed {} | step p50 {:.0f} p99 {:.0f} us\n",
      spec, mean_error, percentile(t.errors_m, 0.5),
      1000 * t.hold_sum_m / static_cast<double>(std::max<std::size_t>(1, t.holds)), t.holds,
      static_cast<double>(t.changes) / t.seconds,
      100.0 * static_cast<double>(t.changes) / static_cast<double>(t.step_us.size()),
      percentile(t.speeds_m_s, 0.99), 1000 * percentile(t.excess_m, 0.99), t.relaxed, t.failed,
      percentile(t.step_us, 0.5), percentile(t.step_us, 0.99));
  std::fflush(stdout);
}

int fail(const Error& error) {
  fmt::print(stderr, "{}\n", error.text());
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    fmt::print(stderr, "usage: abrazo_leave_one_out MANIFEST TAKE[,TAKE...] SPEC...\n");
    return 2;
  }
  const auto manifest = read_manifest(argv[1]);
  if (!manifest) return fail(manifest.error());
  std::vector<std::string> warnings;
  auto built = build_library(*manifest, {}, {}, warnings);
  if (!built) return fail(built.error());
  const auto library = std::make_shared<const MotionLibrary>(std::move(*built));
  std::vector<PairedTake> takes;
  for (const std::string_view name : split_fields(argv[2], ','))
    for (const Manifest::Take& entry : manifest->takes) {
      if (entry.name != name) continue;
      auto take = load_take(entry, warnings);
      if (!take) return fail(take.error());
      takes.push_back(std::move(*take));
    }
  for (int a = 3; a < argc; ++a) {
    const auto settings = parse_spec(argv[a]);
    if (!settings) return fail(settings.error());
    Totals totals;
    for (const PairedTake& take : takes)
      if (const Status done = run_take(take, library, *settings, totals); !done) return fail(done.error());
    print(argv[a], totals);
  }
  return 0;
}
