#pragma once

#include <functional>
#include <vector>

#include "core/metrics/run_summary.hpp"
#include "core/motion/body/clip.hpp"
#include "core/synthesis/step/clip_synthesis.hpp"

namespace abrazo {

/// Results for a recorded input: both characters at the step rate, and a summary.
struct ClipRun {
  Clip active, passive;
  std::vector<double> times_s;  ///< of the input, one per step
  RunSummary summary;           ///< refers to the synthesizer's library

  double rate_hz() const { return active.fps; }
};

/// Solves all of a clip as synthesize_clip does. @param each  called after every step; may be empty
/// @return an Error also if the library's file was damaged meanwhile
Result<ClipRun> run_clip(PartnerSynthesizer& synthesizer, const Clip& clip,
                         const std::function<void(const ClipStep&)>& each, const Progress& progress);

}  // namespace abrazo
