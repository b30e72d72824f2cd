#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "core/base/result.hpp"
#include "core/motion/body/resample.hpp"
#include "core/session/export/export_wish.hpp"

namespace abrazo {

/// The timing with which frames become a motion file: export_session writes by it, and plan_export states it.
/// @param times_s  of the frames @param rate_hz 0 = their median rate
/// @param where  of the frames, for the Error, which says why they are no motion
Result<EvenTiming> plan_motion(std::span<const double> times_s, double rate_hz, const std::string& where);

/// What an export will write.
struct ExportPlan {
  std::uint64_t frames = 0;   ///< exact for motion; of meshes and traces at most, since frames without a mesh
                              ///< or trace are left out
  double rate_hz = 0;         ///< of a motion; 0 = as the frames were solved
  std::uint64_t bridged = 0;  ///< of a motion's frames, those interpolated inside gaps
  std::size_t gaps = 0;       ///< of the recording, see EvenTiming
  std::uint64_t bytes = 0;    ///< accurate to 25 % for motions, 50 % for meshes and traces
};

/// @param times_s  of the frames of the wish's part, ascending
/// @return an Error if these frames cannot be written so
Result<ExportPlan> plan_export(const ExportWish& wish, std::span<const double> times_s);

/// Which frames a series of meshes has: all, or at the wanted rate those that were shown then.
struct SeriesClock {
  double rate_hz = 0;
  double from_s = 0;
  double next_s = from_s;
  bool wants(double time_s);
};

}  // namespace abrazo
