#pragma once

#include <algorithm>
#include <cstddef>
#include <list>

#include "core/video/video_frame.hpp"

namespace abrazo {

/// Least-recently-used cache of pictures, bounded in bytes; holds at least one.
class FrameCache {
 public:
  explicit FrameCache(std::size_t most_bytes) : most_bytes_(most_bytes) {}

  VideoFramePtr find(int index) {
    const auto found = std::ranges::find(frames_, index, [](const VideoFramePtr& f) { return f->index; });
    if (found == frames_.end()) return nullptr;
    frames_.splice(frames_.begin(), frames_, found);
    return frames_.front();
  }
  bool holds(int index) const {
    return std::ranges::find(frames_, index, [](const VideoFramePtr& f) { return f->index; }) !=
           frames_.end();
  }
  void add(VideoFramePtr frame) {
    if (find(frame->index)) return;
    bytes_ += frame->rgb.size();
    frames_.push_front(std::move(frame));
    while (bytes_ > most_bytes_ && frames_.size() > 1) {
      bytes_ -= frames_.back()->rgb.size();
      frames_.pop_back();
    }
  }
  /// Number of pictures of this size that fit.
  int room(std::size_t bytes_each) const {
    return std::max(1, static_cast<int>(most_bytes_ / std::max<std::size_t>(1, bytes_each)));
  }
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t most_bytes_;
  std::size_t bytes_ = 0;
  std::list<VideoFramePtr> frames_;  ///< most recently used first
};

}  // namespace abrazo
