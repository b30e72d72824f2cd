#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/video/video_frame.hpp"

namespace abrazo {

/// A video that is opened and decoded on a thread of its own: only the newest request counts, those between
/// are left out, and the pictures to come are decoded ahead while requests go forwards.
class VideoDecoder {
 public:
  /// Opens on the thread. @param notify  called on it when state() or newest() has something new
  VideoDecoder(std::filesystem::path file, std::function<void()> notify);
  ~VideoDecoder();  ///< stops and waits for the thread

  enum class State { Opening, Open, Failed };
  State state() const;
  double opened() const;  ///< share of the file that was gone through while opening
  Status trouble() const;
  /// Null until the file is open.
  std::shared_ptr<const VideoFacts> facts() const;

  void request(int index);
  /// The picture that was decoded last for a request; null before the first.
  VideoFramePtr newest() const;
  std::optional<int> requested() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace abrazo
