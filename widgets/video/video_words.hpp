#pragma once

#include <string>

#include "core/video/video_frame.hpp"
#include "core/video/video_sync.hpp"

namespace abrazo::widgets {

/// "1:02.345", with a minus before it where it is before the beginning.
std::string clock_text(double time_s);
/// "1280 × 720 · h264 · 25 Hz · 48.0 s", and what the file says wrongly of itself.
std::string facts_text(const VideoFacts& facts);
/// "both begin together", "the video is 1.250 s ahead".
std::string offset_text(const VideoSync& sync);
/// "rate 1.000120: the video gains 7.2 ms a minute"
std::string rate_text(const VideoSync& sync);
/// How far the video runs from the timeline in a minute [ms]; positive = it is faster.
double drift_ms_per_minute(const VideoSync& sync);
/// How to go on: what the points there are say, and what another would.
std::string sync_advice(const VideoSync& sync);
/// "308 of 1200"
std::string picture_text(int index, int pictures);

/// The same moment in both. With two points already the nearer one is moved there. A point at the same time
/// of the subject is replaced.
VideoSync with_sync_point(const VideoSync& sync, const SyncPoint& point);
VideoSync without_sync_point(const VideoSync& sync, std::size_t index);
/// So that the video shows `offset_s` when the timeline is at 0; the rate stays.
VideoSync with_offset(const VideoSync& sync, double offset_s);
/// Around the first point; a second one would contradict, and goes.
VideoSync with_rate(const VideoSync& sync, double rate);

}  // namespace abrazo::widgets
