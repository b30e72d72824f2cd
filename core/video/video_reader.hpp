#pragma once

#include <filesystem>
#include <memory>

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/video/video_frame.hpp"

namespace abrazo {

/// Reads any picture of a video exactly: the same index gives the same picture, however it was come to.
/// Not for two threads at once.
class VideoReader {
 public:
  /// Goes through the file once for the times of its pictures. The error says what the file is instead of a
  /// video that can be read.
  static Result<VideoReader> open(const std::filesystem::path& file, const Progress& progress);
  VideoReader(VideoReader&&) noexcept;
  VideoReader& operator=(VideoReader&&) noexcept;
  ~VideoReader();

  const VideoFacts& facts() const;
  /// @param index     within the facts' frames. The last ones that were read are kept for a while
  /// @param progress  asked while decoding; false gives up with an Error "cancelled"
  Result<VideoFramePtr> frame(int index, const Progress& progress = {});
  /// It is among those that are kept: frame() returns it without decoding.
  bool holds(int index) const;

 private:
  struct State;
  explicit VideoReader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace abrazo
