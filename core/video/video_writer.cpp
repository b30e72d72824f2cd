#include "core/video/video_writer.hpp"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <string>
#include <system_error>

namespace abrazo {

struct VideoWriter::State {
  std::filesystem::path target;
  std::filesystem::path partial;  ///< ends in the target's extension: OpenCV chooses the container by it
  cv::VideoWriter video;
  cv::Mat bgr;
  int width = 0;
  int height = 0;
  int frames = 0;

  ~State() {
    video.release();
    std::error_code ignored;
    std::filesystem::remove(partial, ignored);
  }
};

VideoWriter::VideoWriter(std::unique_ptr<State> state) : state_(std::move(state)) {}
VideoWriter::VideoWriter(VideoWriter&&) noexcept = default;
VideoWriter& VideoWriter::operator=(VideoWriter&&) noexcept = default;
VideoWriter::~VideoWriter() = default;

Result<VideoWriter> VideoWriter::open(const std::filesystem::path& file, int width, int height, double fps) {
  if (width <= 0 || height <= 0 || width % 2 != 0 || height % 2 != 0 || !(fps > 0))
    return Error{"a video needs an even size and a rate above 0; found " + std::to_string(width) + " x " +
                     std::to_string(height) + " at " + std::to_string(fps) + " Hz",
                 file.string()};
  auto state = std::make_unique<State>();
  state->target = file;
  state->partial = file.parent_path() / (file.stem().string() + ".part" + file.extension().string());
  state->width = width;
  state->height = height;
  state->video.open(state->partial.string(), cv::VideoWriter::fourcc('m', 'p', '4', 'v'), fps,
                    cv::Size(width, height));
  if (!state->video.isOpened())
    return Error{
        "cannot be written as MPEG-4 video; check that the folder exists and that the name ends in .mp4",
        file.string()};
  return VideoWriter(std::move(state));
}

Status VideoWriter::add(std::span<const std::uint8_t> rgb, std::size_t stride) {
  const auto row = static_cast<std::size_t>(state_->width) * 3;
  const auto needed = stride * static_cast<std::size_t>(state_->height - 1) + row;
  if (stride < row || rgb.size() < needed)
    return Error{"a picture of " + std::to_string(rgb.size()) + " bytes does not fill " +
                     std::to_string(state_->width) + " x " + std::to_string(state_->height) + " pixels",
                 state_->target.string()};
  // OpenCV has no const view; the picture is only read.
  const cv::Mat picture(state_->height, state_->width, CV_8UC3, const_cast<std::uint8_t*>(rgb.data()),
                        stride);
  cv::cvtColor(picture, state_->bgr, cv::COLOR_RGB2BGR);
  state_->video.write(state_->bgr);
  ++state_->frames;
  return Done{};
}

int VideoWriter::frames() const {
  return state_->frames;
}

Status VideoWriter::finish() {
  state_->video.release();
  cv::VideoCapture back(state_->partial.string());
  const int found = back.isOpened() ? static_cast<int>(back.get(cv::CAP_PROP_FRAME_COUNT)) : 0;
  back.release();
  if (found != state_->frames)
    return Error{"the video came out with " + std::to_string(found) + " of " +
                     std::to_string(state_->frames) + " pictures; check that the disk is not full",
                 state_->target.string()};
  std::error_code failure;
  std::filesystem::rename(state_->partial, state_->target, failure);
  if (failure) return Error{"cannot be written: " + failure.message(), state_->target.string()};
  return Done{};
}

}  // namespace abrazo
