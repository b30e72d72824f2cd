#include "core/video/picture_stream.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>

namespace abrazo {
namespace {

constexpr double most_pictures = 1e8;

/// Clockwise. OpenCV 4.6.0 tells it the other way round (its issue 22088; right before and after).
int quarter_turns(double degrees) {
  const bool is_reversed = cv::getVersionMajor() == 4 && cv::getVersionMinor() == 6;
  if (is_reversed) degrees = -degrees;
  return ((static_cast<int>(std::lround(degrees / 90)) % 4) + 4) % 4 * 90;
}

}  // namespace

/// What FFmpeg has to say of a file is said by the reader, as a message instead.
void PictureStream::silence_backend() {
  static std::once_flag once;
  std::call_once(once, [] {
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  });
}

bool PictureStream::open(const std::filesystem::path& file) {
  silence_backend();
  file_ = std::filesystem::absolute(file);  // never a protocol, whatever its name looks like
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

bool PictureStream::next() {
  try {
    return capture_.grab();
  } catch (const cv::Exception&) {
    return false;
  }
}

double PictureStream::stamp_ms() const {
  return capture_.get(cv::CAP_PROP_POS_MSEC);
}

bool PictureStream::jump(double seconds_after_start) {
  // OpenCV 4.6 knows the time of the picture it lands on only when the next one was decoded.
  const double picture = std::floor(seconds_after_start * nominal_hz()) - 1;
  if (picture < 2) return false;  // it decodes nothing then
  try {
    return capture_.set(cv::CAP_PROP_POS_FRAMES, picture) && capture_.grab();
  } catch (const cv::Exception&) {
    return false;
  }
}

cv::Mat PictureStream::decoded() const {
  cv::Mat bgr;
  try {
    if (!capture_.retrieve(bgr) || bgr.type() != CV_8UC3) return {};
  } catch (const cv::Exception&) {
    return {};
  }
  return bgr;
}

cv::Mat PictureStream::picture() const {
  const cv::Mat bgr = decoded();
  if (bgr.empty()) return {};
  cv::Mat rgb;
  cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
  if (rotation_deg_ == 90) cv::rotate(rgb, rgb, cv::ROTATE_90_CLOCKWISE);
  if (rotation_deg_ == 180) cv::rotate(rgb, rgb, cv::ROTATE_180);
  if (rotation_deg_ == 270) cv::rotate(rgb, rgb, cv::ROTATE_90_COUNTERCLOCKWISE);
  return rgb;
}

std::uint64_t PictureStream::fingerprint() const {
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

double PictureStream::nominal_hz() const {
  const double hz = capture_.get(cv::CAP_PROP_FPS);
  return std::isfinite(hz) && hz > 0 ? hz : 0;
}

int PictureStream::promised() const {
  const double count = capture_.get(cv::CAP_PROP_FRAME_COUNT);
  return count > 0 && count < most_pictures ? static_cast<int>(count) : 0;
}

std::string PictureStream::codec() const {
  const auto fourcc = static_cast<std::uint32_t>(capture_.get(cv::CAP_PROP_FOURCC));
  std::string name;
  for (int i = 0; i < 4; ++i) {
    const char c = static_cast<char>(fourcc >> (8 * i) & 0xff);
    if (c > ' ' && c < 127) name += c;
  }
  return name == "avc1" || name == "H264" || name == "h264" ? "h264" : name;
}

double PictureStream::pixel_aspect() const {
  const double wide = capture_.get(cv::CAP_PROP_SAR_NUM), high = capture_.get(cv::CAP_PROP_SAR_DEN);
  return wide > 0 && high > 0 ? wide / high : 1;
}

}  // namespace abrazo
