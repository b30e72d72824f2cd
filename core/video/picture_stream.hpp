#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/videoio.hpp>
#include <string>

namespace abrazo {

/// The pictures of a video one after the other, as OpenCV's FFmpeg backend decodes them. Where a jump lands
/// is only known by the time of the picture it lands on: OpenCV counts in an average rate.
class PictureStream {
 public:
  /// Keeps the backend from writing to the console. It changes the environment: to be called before threads
  /// start that open videos; opening calls it as well.
  static void silence_backend();
  /// @return false where there is nothing that decodes; what was open before is closed
  bool open(const std::filesystem::path& file);
  /// At the beginning again, before the first picture.
  bool restart() { return open(file_); }

  bool next();
  /// Of the picture that was decoded last, by the clock of the file.
  double stamp_ms() const;
  /// About there, a little earlier if anything; a picture is decoded.
  bool jump(double seconds_after_start);
  /// The one that was decoded last: upright, red, green, blue. Empty where it cannot be had.
  cv::Mat picture() const;
  /// Of the picture as it is decoded; two that differ have another with all likelihood.
  std::uint64_t fingerprint() const;

  double nominal_hz() const;
  int promised() const;
  int rotation_deg() const { return rotation_deg_; }
  std::string codec() const;
  /// Width of a pixel by its height.
  double pixel_aspect() const;

 private:
  cv::Mat decoded() const;

  std::filesystem::path file_;
  mutable cv::VideoCapture capture_;  // OpenCV's readers are not const
  int rotation_deg_ = 0;
};

}  // namespace abrazo
