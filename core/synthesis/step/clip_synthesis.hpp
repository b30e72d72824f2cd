#pragma once

#include <functional>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/motion/body/clip.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"

namespace abrazo {

/// One solved step of a recorded input.
struct ClipStep {
  long long input_frame = 0;  ///< 0-based
  double time_s = 0;          ///< of the input frame
  const FrameResult& result;
};

/// Steps per second over a clip: the setting, or the clip's own rate up to 120 Hz; never more than the clip
/// has.
double clip_step_rate(const Clip& clip, const Settings& settings);

/// Runs the whole pipeline over a recorded input at clip_step_rate(), not in real time. The user's body is
/// measured over the whole clip. @param each called after every step
Status synthesize_clip(PartnerSynthesizer& synthesizer, const Clip& clip,
                       const std::function<Status(const ClipStep&)>& each, const Progress& progress);

}  // namespace abrazo
