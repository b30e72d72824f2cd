#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.hpp"
#include "core/video/video_frame.hpp"

namespace abrazo {

/// Opens and decodes a video on a separate thread: only the newest request is served, older ones are skipped,
/// and pictures are decoded ahead while requests move forward.
class VideoDecoder {
 public:
  /// Opens the file on the thread. @param notify called on it when state() or newest() changed
  VideoDecoder(std::filesystem::path file, std::function<void()> notify);
  ~VideoDecoder();  ///< stops and waits for the thread

  enum class State { Opening, Open, Failed };
  State state() const;
  double opened() const;  ///< progress of opening, 0 to 1
  Status trouble() const;
  /// Null until the file is open.
  std::shared_ptr<const VideoFacts> facts() const;

  void request(int index);
  /// The last picture decoded for a request; null before the first.
  VideoFramePtr newest() const;
  std::optional<int> requested() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace abrazo
