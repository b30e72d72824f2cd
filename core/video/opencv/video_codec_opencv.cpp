// The module that decodes and encodes videos with OpenCV's FFmpeg backend; see VideoCodec.
#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "core/base/limits.hpp"
#include "core/video/video_codec.hpp"

namespace abrazo {
namespace {

constexpr double most_pictures = 1e8;

/// Clockwise. OpenCV 4.6.0 reports it the other way round (its issue 22088; right before and after).
int quarter_turns(double degrees) {
  const bool is_reversed = cv::getVersionMajor() == 4 && cv::getVersionMinor() == 6;
  if (is_reversed) degrees = -degrees;
  return ((static_cast<int>(std::lround(degrees / 90)) % 4) + 4) % 4 * 90;
}

/// OpenCV counts in an average rate.
class OpenCvStream final : public PictureStream {
 public:
  bool open(const std::filesystem::path& file) override;
  bool restart() override;
  bool next() override;
  double stamp_ms() const override;
  bool jump(double seconds_after_start) override;
  DecodedPicture picture() const override;
  std::uint64_t fingerprint() const override;
  std::array<int, 2> promised_size() const override;
  double nominal_hz() const override;
  int promised() const override;
  int rotation_deg() const override { return rotation_deg_; }
  void turn(int degrees, bool mirrors) override { rotation_deg_ = degrees, is_mirrored_ = mirrors; }
  std::string codec() const override;
  double pixel_aspect() const override;

 private:
  cv::Mat decoded() const;

  std::filesystem::path file_;
  mutable cv::VideoCapture capture_;  // OpenCV's readers are not const
  int rotation_deg_ = 0;
  bool is_mirrored_ = false;
};

bool OpenCvStream::open(const std::filesystem::path& file) {
  file_ = file;
  try {
    capture_.open(file_.string(), cv::CAP_FFMPEG);
    if (!capture_.isOpened()) return false;
    capture_.set(cv::CAP_PROP_ORIENTATION_AUTO, 0);
    rotation_deg_ = quarter_turns(capture_.get(cv::CAP_PROP_ORIENTATION_META));
    return true;
  } catch (const cv::Exception&) {
    return false;
  }
}

bool OpenCvStream::restart() {
  const int degrees = rotation_deg_;
  const bool is_open = open(file_);
  rotation_deg_ = degrees;
  return is_open;
}

bool OpenCvStream::next() {
  try {
    return capture_.grab();
  } catch (const cv::Exception&) {
    return false;
  }
}

double OpenCvStream::stamp_ms() const {
  return capture_.get(cv::CAP_PROP_POS_MSEC);
}

bool OpenCvStream::jump(double seconds_after_start) {
  // OpenCV 4.6 knows the time of the picture it lands on only when the next one was decoded.
  const double picture = std::floor(seconds_after_start * nominal_hz()) - 1;
  if (picture < 2) return false;  // it decodes nothing then
  try {
    return capture_.set(cv::CAP_PROP_POS_FRAMES, picture) && capture_.grab();
  } catch (const cv::Exception&) {
    return false;
  }
}

cv::Mat OpenCvStream::decoded() const {
  cv::Mat bgr;
  try {
    if (!capture_.retrieve(bgr) || bgr.type() != CV_8UC3) return {};
  } catch (const cv::Exception&) {
    return {};
  }
  return bgr;
}

DecodedPicture OpenCvStream::picture() const {
  const cv::Mat bgr = decoded();
  if (bgr.empty()) return {};
  cv::Mat rgb;
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  if (is_mirrored_) cv::flip(rgb, rgb, 1);
  if (rotation_deg_ == 90) cv::rotate(rgb, rgb, cv::ROTATE_90_CLOCKWISE);
  if (rotation_deg_ == 180) cv::rotate(rgb, rgb, cv::ROTATE_180);
  if (rotation_deg_ == 270) cv::rotate(rgb, rgb, cv::ROTATE_90_COUNTERCLOCKWISE);
  return {rgb.cols, rgb.rows, {rgb.datastart, rgb.dataend}};  // converted pictures have no padding
}

std::uint64_t OpenCvStream::fingerprint() const {
  const cv::Mat bgr = decoded();
  std::uint64_t sum = 1469598103934665603u;
  for (int y = 0; y < bgr.rows; ++y) {
    const std::uint8_t* row = bgr.ptr<std::uint8_t>(y);
    const std::size_t bytes = static_cast<std::size_t>(bgr.cols) * 3;
    for (std::size_t x = 0; x < bytes; x += 8) {
      std::uint64_t word = 0;
      std::memcpy(&word, row + x, std::min<std::size_t>(8, bytes - x));
      sum = (sum ^ word) * 1099511628211u;
      sum ^= sum >> 29;
    }
  }
  return sum;
}

std::array<int, 2> OpenCvStream::promised_size() const {
  return {static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_WIDTH)),
          static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_HEIGHT))};
}

double OpenCvStream::nominal_hz() const {
  const double hz = capture_.get(cv::CAP_PROP_FPS);
  return std::isfinite(hz) && hz > 0 ? hz : 0;
}

int OpenCvStream::promised() const {
  const double count = capture_.get(cv::CAP_PROP_FRAME_COUNT);
  return count > 0 && count < most_pictures ? static_cast<int>(count) : 0;
}

std::string OpenCvStream::codec() const {
  const auto fourcc = static_cast<std::uint32_t>(capture_.get(cv::CAP_PROP_FOURCC));
  std::string name;
  for (int i = 0; i < 4; ++i) {
    const char c = static_cast<char>(fourcc >> (8 * i) & 0xff);
    if (c > ' ' && c < 127) name += c;
  }
  return name == "avc1" || name == "H264" || name == "h264" ? "h264" : name;
}

double OpenCvStream::pixel_aspect() const {
  const double wide = capture_.get(cv::CAP_PROP_SAR_NUM), high = capture_.get(cv::CAP_PROP_SAR_DEN);
  return wide > 0 && high > 0 ? wide / high : 1;
}

class OpenCvSink final : public PictureSink {
 public:
  bool open(const std::filesystem::path& file, int width, int height, double fps) override {
    width_ = width, height_ = height;
    video_.open(file.string(), cv::CAP_FFMPEG, cv::VideoWriter::fourcc('m', 'p', '4', 'v'), fps,
                cv::Size(width, height));
    return video_.isOpened();
  }
  void add(const std::uint8_t* rgb, std::size_t stride) override {
    // OpenCV has no const view; the picture is only read.
    const cv::Mat picture(height_, width_, CV_8UC3, const_cast<std::uint8_t*>(rgb), stride);
    cv::cvtColor(picture, bgr_, cv::COLOR_RGB2BGR);
    video_.write(bgr_);
  }
  void close() override { video_.release(); }

 private:
  cv::VideoWriter video_;
  cv::Mat bgr_;
  int width_ = 0, height_ = 0;
};

class OpenCvCodec final : public VideoCodec {
 public:
  OpenCvCodec() {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    // A picture within a file may be larger than those before, which is known once it is decoded. So FFmpeg
    // reserves no more at once than the largest picture takes as it is handed on, and some padding.
    constexpr std::size_t most_bytes = 3 * static_cast<std::size_t>(limits::video_pixels) + (1U << 20U);
    if (void* most = ::dlsym(RTLD_DEFAULT, "av_max_alloc"))
      reinterpret_cast<void (*)(std::size_t)>(most)(most_bytes);
  }
  std::unique_ptr<PictureStream> stream() const override { return std::make_unique<OpenCvStream>(); }
  std::unique_ptr<PictureSink> sink() const override { return std::make_unique<OpenCvSink>(); }
  int pictures_in(const std::filesystem::path& file) const override {
    cv::VideoCapture back(file.string(), cv::CAP_FFMPEG);
    return back.isOpened() ? static_cast<int>(back.get(cv::CAP_PROP_FRAME_COUNT)) : 0;
  }
};

}  // namespace
}  // namespace abrazo

extern "C" __attribute__((visibility("default"))) const abrazo::VideoCodec* abrazo_video_codec() {
  static const abrazo::OpenCvCodec codec;
  return &codec;
}
