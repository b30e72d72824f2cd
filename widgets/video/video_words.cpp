#include "widgets/video/video_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace abrazo::widgets {
namespace {

constexpr double same_instant_s = 1e-4;
constexpr double ms_per_minute = 60'000;

std::string fixed(double value, int decimals) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

/// As many digits as it takes: 25, 29.97.
std::string shortest(double value) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.6g", value);
  return text.data();
}

}  // namespace

std::string facts_text(const VideoFacts& facts) {
  std::string text = std::to_string(facts.width) + " × " + std::to_string(facts.height);
  if (!facts.codec.empty()) text += " · " + facts.codec;
  text += " · " + shortest(facts.rate_hz) + (facts.is_even ? " Hz" : " Hz, uneven");
  if (facts.rotation_deg != 0) text += " · turned by " + std::to_string(facts.rotation_deg) + "°";
  if (facts.is_mirrored) text += " · mirrored";
  return text + " · " + fixed(facts.duration_s(), 1) + " s";
}

std::string offset_text(const VideoSync& sync) {
  const double offset_s = sync.video_time(0);
  if (std::abs(offset_s) < 0.0005) return "both begin together";
  return offset_s > 0 ? "the video began " + fixed(offset_s, 3) + " s earlier"
                      : "the video began " + fixed(-offset_s / sync.effective_rate(), 3) + " s later";
}

double drift_ms_per_minute(const VideoSync& sync) {
  return (sync.effective_rate() - 1) * ms_per_minute;
}

std::string rate_text(const VideoSync& sync) {
  const double drift_ms = drift_ms_per_minute(sync);
  if (std::abs(drift_ms) < 0.05) return "both at the same rate";
  const char* how = drift_ms > 0 ? "gains" : "loses";
  const double ms = std::abs(drift_ms);
  return "rate " + fixed(sync.effective_rate(), 6) + ": the video " + how + " " +
         (ms < 2000 ? fixed(ms, 1) + " ms" : fixed(ms / 1000, 2) + " s") + " a minute";
}

std::string sync_advice(const VideoSync& sync) {
  switch (sync.points.size()) {
    case 0:
      return "Not yet synchronised. Unlink, step the video to where it shows the moment at the cursor, and "
             "press "
             "Same moment.";
    case 1:
      return "One point gives the offset. A second one, far from it, gives the rate too.";
    default:
      return "Two points, " + fixed(std::abs(sync.points[1].subject_s - sync.points[0].subject_s), 1) +
             " s apart. Another replaces the nearer one.";
  }
}

std::string picture_text(int index, int pictures) {
  return std::to_string(index + 1) + " of " + std::to_string(pictures);
}

VideoSync with_sync_point(const VideoSync& sync, const SyncPoint& point) {
  VideoSync next = sync;
  const auto apart = [&](const SyncPoint& other) { return std::abs(other.subject_s - point.subject_s); };
  const auto nearest = std::ranges::min_element(next.points, {}, apart);
  const bool replaces =
      nearest != next.points.end() && (next.points.size() > 1 || apart(*nearest) < same_instant_s);
  replaces ? void(*nearest = point) : next.points.push_back(point);
  std::ranges::sort(next.points, {}, &SyncPoint::subject_s);
  return next;
}

VideoSync without_sync_point(const VideoSync& sync, std::size_t index) {
  if (index >= sync.points.size()) return sync;
  VideoSync next = sync;
  if (next.points.size() == 2) next.rate = 1;  // the two gave it
  next.points.erase(next.points.begin() + static_cast<std::ptrdiff_t>(index));
  return next;
}

VideoSync with_offset(const VideoSync& sync, double offset_s) {
  VideoSync next = sync;
  if (next.points.empty()) next.points.push_back({0, sync.video_time(0)});
  const double by = offset_s - sync.video_time(0);
  for (SyncPoint& point : next.points) point.video_s += by;
  return next;
}

VideoSync with_rate(const VideoSync& sync, double rate) {
  VideoSync next = sync;
  if (next.points.size() > 1) next.points.resize(1);
  next.rate = rate;
  return next;
}

}  // namespace abrazo::widgets
