#include "core/synthesis/step/clip_synthesis.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/text.hpp"
#include "core/motion/body/body.hpp"

namespace abrazo {

namespace {
constexpr double highest_step_rate_hz = 120;
constexpr double lowest_rate_hz = 5;  ///< below, every step would come after a tracking loss
}  // namespace

double clip_step_rate(const Clip& clip, const Settings& settings) {
  const double wanted = settings.step_rate_hz > 0 ? settings.step_rate_hz : highest_step_rate_hz;
  return std::min(wanted, clip.fps);
}

Status synthesize_clip(PartnerSynthesizer& synthesizer, const Clip& clip,
                       const std::function<Status(const ClipStep&)>& each, const Progress& progress) {
  if (clip.poses.empty()) return Error{"the input has no frames", clip.name};
  if (!(clip.fps >= lowest_rate_hz))
    return Error{"the input has " + exact_text(clip.fps) +
                     " frames per second; at least 5 are needed; set the rate if the file's is wrong",
                 clip.name, Hint::SetFrameRate};
  synthesizer.set_user_body(body_of(clip.poses));
  const double rate = clip_step_rate(clip, synthesizer.settings());
  const auto frames = static_cast<long long>(clip.poses.size());
  double previous_time_s = 0;
  for (long long step = 0;; ++step) {
    // Rounded from the step's own time, so that a rate that does not divide the clip's does not drift.
    const long long frame = std::llround(static_cast<double>(step) * clip.fps / rate);
    if (frame >= frames) return Done{};
    const double time_s = static_cast<double>(frame) / clip.fps;
    const FrameResult& result = synthesizer.step(clip.poses[static_cast<std::size_t>(frame)],
                                                 Duration(step == 0 ? 0.0 : time_s - previous_time_s));
    previous_time_s = time_s;
    const Status kept = each({frame, time_s, result});
    if (!kept) return kept;
    if (step % 64 == 0 &&
        !report(progress, static_cast<double>(frame) / static_cast<double>(frames), "synthesising"))
      return Error{"cancelled", clip.name};
  }
}

}  // namespace abrazo
