#include "core/metrics/clip_run.hpp"

#include <utility>

namespace abrazo {

Result<ClipRun> run_clip(PartnerSynthesizer& synthesizer, const Clip& clip,
                         const std::function<void(const ClipStep&)>& each, const Progress& progress) {
  const double rate_hz = clip_step_rate(clip, synthesizer.settings());
  ClipRun run{{"active", rate_hz, {}},
              {"passive", rate_hz, {}},
              {},
              RunSummary(synthesizer.library(), synthesizer.settings().user_role)};
  const Status solved = synthesize_clip(
      synthesizer, clip,
      [&](const ClipStep& step) -> Status {
        if (each) each(step);
        run.active.poses.emplace_back(step.result.active());
        run.passive.poses.emplace_back(step.result.passive());
        run.times_s.push_back(step.time_s);
        run.summary.add(step.result, step.time_s);
        return Done{};
      },
      progress);
  if (!solved) return solved.error();
  if (const auto damage = synthesizer.library().damage()) return *damage;
  return run;
}

}  // namespace abrazo
