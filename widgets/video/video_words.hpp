#pragma once

#include <string>

#include "core/video/video_frame.hpp"
#include "core/video/video_sync.hpp"

namespace abrazo::widgets {

/// "1280 × 720 · h264 · 25 Hz · 48.0 s", and wrong statements of the header.
std::string facts_text(const VideoFacts& facts);
/// "both begin together", "the video is 1.250 s ahead".
std::string offset_text(const VideoSync& sync);
/// "rate 1.000120: the video gains 7.2 ms a minute"
std::string rate_text(const VideoSync& sync);
/// Drift of the video per minute [ms]; positive = it is faster.
double drift_ms_per_minute(const VideoSync& sync);
/// Advice: meaning of the present points, and of another one.
std::string sync_advice(const VideoSync& sync);
/// "308 of 1200"
std::string picture_text(int index, int pictures);

/// Adds a sync point. With two points, moves the nearer one. Replaces a point at the same time of the
/// subject.
VideoSync with_sync_point(const VideoSync& sync, const SyncPoint& point);
VideoSync without_sync_point(const VideoSync& sync, std::size_t index);
/// Makes the video show `offset_s` when the timeline is at 0; the rate stays.
VideoSync with_offset(const VideoSync& sync, double offset_s);
/// Sets the rate about the first point and removes the second, which would contradict.
VideoSync with_rate(const VideoSync& sync, double rate);

}  // namespace abrazo::widgets
