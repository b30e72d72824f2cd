#include "core/session/export/export_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace abrazo {

namespace {

// Bytes per frame, measured over generated dances.
constexpr double bvh_bytes = 885, csv_bytes = 1480, glb_bytes = 620;  // of a body
constexpr double point_bytes = 24;                                    // of a point in a .npz or .npy
constexpr double glb_skin_bytes = 155e3;                              // of a body, once
constexpr double character_bytes = 370;                               // of a body that a character performs
constexpr double character_tracks_bytes = 3.9e3;  // of such a body once, beside the character's file
constexpr double vtu_bytes = 40e3, trace_bytes = 29e3, label_bytes = 40;

constexpr double most_motion_frames = 10e6;

std::uint64_t motion_bytes(const ExportWish& wish, double frames) {
  const auto bodies = static_cast<double>(wish.bodies.size());
  const auto ends_with = [&](const char* type) { return wish.output.ends_with(type); };
  double body = frames * csv_bytes;
  if (!wish.character.empty()) {
    std::error_code unreadable;
    const std::uintmax_t character = std::filesystem::file_size(wish.character, unreadable);
    body =
        frames * character_bytes + character_tracks_bytes + (unreadable ? 0 : static_cast<double>(character));
  } else if (ends_with(".bvh")) {
    body = frames * bvh_bytes;
  } else if (ends_with(".glb")) {
    body = frames * glb_bytes + glb_skin_bytes;
  } else if (ends_with(".npz") || ends_with(".npy")) {
    const std::size_t points =
        wish.space.joints ? wish.space.joints->points.size() : std::size_t{joint_count};
    body = frames * point_bytes * static_cast<double>(points);
  }
  return static_cast<std::uint64_t>(bodies * body);
}

std::uint64_t series_frames(const ExportWish& wish, std::span<const double> times_s) {
  SeriesClock clock{wish.rate_hz, times_s.front()};
  return static_cast<std::uint64_t>(
      std::ranges::count_if(times_s, [&](double time_s) { return clock.wants(time_s); }));
}

}  // namespace

bool SeriesClock::wants(double time_s) {
  if (rate_hz <= 0) return true;
  if (time_s + 1e-9 < next_s) return false;
  next_s = from_s + (std::floor((time_s - from_s + 1e-9) * rate_hz + 1e-6) + 1) / rate_hz;
  return true;
}

Result<EvenTiming> plan_motion(std::span<const double> times_s, double rate_hz, const std::string& where) {
  const double rate = rate_hz > 0 ? rate_hz : even_rate(median_rate_hz(times_s));
  if (!(rate > 0)) return Error{"a single frame has no rate; give one, or a longer part", where};
  const auto [first_s, last_s] = std::ranges::minmax(times_s);
  const double frames = (last_s - first_s) * rate;
  if (!(frames < most_motion_frames))
    return Error{
        fmt::format("would be {:.3g} frames at {:.6g} Hz, more than {:.0f}; choose a shorter part or a "
                    "lower rate",
                    frames, rate, most_motion_frames),
        where};
  return even_timing(times_s, rate);
}

Result<ExportPlan> plan_export(const ExportWish& wish, std::span<const double> times_s) {
  ExportPlan plan;
  if (times_s.empty() && !wish.one_mesh())
    return Error{"there are no frames in this part; choose another", wish.output};
  plan.frames = times_s.size();
  switch (wish.content) {
    case ExportContent::Motion: {
      const auto timing = plan_motion(times_s, wish.rate_hz, wish.output);
      if (!timing) return timing.error();
      plan.frames = timing->frames;
      plan.rate_hz = timing->rate_hz;
      plan.bridged = timing->bridged;
      plan.gaps = timing->gaps;
      plan.bytes = motion_bytes(wish, static_cast<double>(plan.frames));
      break;
    }
    case ExportContent::Mesh:
      plan.frames = wish.one_mesh() ? 1 : series_frames(wish, times_s);
      plan.bytes = static_cast<std::uint64_t>(static_cast<double>(plan.frames) * vtu_bytes);
      break;
    case ExportContent::Labels:
      plan.bytes = static_cast<std::uint64_t>(4e3 + (times_s.back() - times_s.front()) * label_bytes);
      break;
    case ExportContent::Trace:
      plan.bytes = static_cast<std::uint64_t>(static_cast<double>(plan.frames) * trace_bytes);
      break;
  }
  return plan;
}

}  // namespace abrazo
