#pragma once

#include <filesystem>
#include <memory>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/video/video_frame.hpp"

namespace abrazo {

/// Reads any picture of a video exactly: the same index always gives the same picture. Not thread-safe.
class VideoReader {
 public:
  /// Reads the file once for the times of its pictures. The Error says what the file is instead of a readable
  /// video.
  static Result<VideoReader> open(const std::filesystem::path& file, const Progress& progress);
  VideoReader(VideoReader&&) noexcept;
  VideoReader& operator=(VideoReader&&) noexcept;
  ~VideoReader();

  const VideoFacts& facts() const;
  /// @param index within the facts' frames. The last pictures are cached
  /// @param progress called while decoding; false ends with an Error "cancelled"
  Result<VideoFramePtr> frame(int index, const Progress& progress = {});
  /// Whether it is cached: frame() returns it without decoding.
  bool holds(int index) const;

 private:
  struct State;
  explicit VideoReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace abrazo
