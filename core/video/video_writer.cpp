#include "core/video/video_writer.hpp"

#include <string>
#include <system_error>

#include "core/base/atomic_file.hpp"
#include "core/video/video_codec.hpp"

namespace abrazo {

struct VideoWriter::State {
  explicit State(const std::filesystem::path& file)
      : target(file), written(file, file.extension().string()) {}  // OpenCV chooses the container by it
  ~State() {
    if (video) video->close();
  }

  std::filesystem::path target;
  AtomicFile written;
  const VideoCodec* codec = nullptr;
  std::unique_ptr<PictureSink> video;
  int width = 0;
  int height = 0;
  int frames = 0;
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
  const auto codec = video_codec();
  if (!codec) return codec.error();
  // Absolute, so that no name is interpreted as a server address.
  std::error_code failure;
  auto state = std::make_unique<State>(std::filesystem::absolute(file, failure));
  state->codec = *codec;
  state->video = (*codec)->sink();
  state->width = width;
  state->height = height;
  if (!state->video->open(state->written.partial(), width, height, fps))
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
  state_->video->add(rgb.data(), stride);
  ++state_->frames;
  return Done{};
}

int VideoWriter::frames() const {
  return state_->frames;
}

Status VideoWriter::finish() {
  state_->video->close();
  const int found = state_->codec->pictures_in(state_->written.partial());
  if (found != state_->frames)
    return Error{"the video came out with " + std::to_string(found) + " of " +
                     std::to_string(state_->frames) + " pictures; check that the disk is not full",
                 state_->target.string()};
  return state_->written.commit();
}

}  // namespace abrazo
