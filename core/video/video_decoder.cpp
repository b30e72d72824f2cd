#include "core/video/video_decoder.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "core/video/video_codec.hpp"
#include "core/video/video_reader.hpp"

namespace abrazo {
namespace {

constexpr int pictures_ahead = 12;

}  // namespace

class VideoDecoder::Work {
 public:
  Work(std::filesystem::path file, std::function<void()> notify)
      : file_(std::move(file)), notify_(std::move(notify)) {
    silence_video_codec();
    thread_ = std::thread([this] { run(); });
  }

  ~Work() {
    {
      const std::lock_guard lock(mutex_);
      stops_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }

  State state() const { return locked(state_); }
  Status trouble() const { return locked(trouble_); }
  std::shared_ptr<const VideoFacts> facts() const { return locked(facts_); }
  VideoFramePtr newest() const { return locked(newest_); }
  std::optional<int> requested() const { return locked(requested_); }
  double opened() const { return opened_; }

  void request(int index) {
    {
      const std::lock_guard lock(mutex_);
      before_ = requested_;
      requested_ = index;
      is_new_ = true;
    }
    wake_.notify_all();
  }

 private:
  template <typename T>
  T locked(const T& value) const {
    const std::lock_guard lock(mutex_);
    return value;
  }

  void tell() const {
    if (notify_) notify_();
  }

  void run() {
    try {
      auto reader = open();
      if (reader) serve(*reader);
    } catch (const std::exception& failure) {
      fail(Error{std::string("the video cannot be read on: ") + failure.what(), file_.string()});
    }
  }

  void fail(const Error& error) {
    {
      const std::lock_guard lock(mutex_);
      state_ = State::Failed;
      trouble_ = error;
    }
    tell();
  }

  Result<VideoReader> open() {
    int told_percent = 0;
    auto reader = VideoReader::open(file_, [&](double fraction, std::string_view) {
      opened_ = fraction;
      if (const int percent = static_cast<int>(fraction * 100); percent > told_percent) {
        told_percent = percent;
        tell();
      }
      return !stops_;
    });
    if (stops_) return Error{"cancelled", file_.string()};
    if (!reader) {
      fail(reader.error());
      return reader;
    }
    {
      const std::lock_guard lock(mutex_);
      facts_ = std::make_shared<const VideoFacts>(reader->facts());
      state_ = State::Open;
    }
    opened_ = 1;
    tell();
    return reader;
  }

  /// The request that was not answered yet, or the next picture ahead; nothing to stop.
  struct Task {
    int index = 0;
    bool is_asked = false;
  };
  std::optional<Task> next_task(const VideoReader& reader, int ahead_of, bool& continues) {
    std::unique_lock lock(mutex_);
    const auto ahead = [&]() -> std::optional<int> {
      if (!continues || ahead_of < 0) return {};
      const int last = std::min(reader.facts().frames() - 1, ahead_of + pictures_ahead);
      for (int index = ahead_of + 1; index <= last; ++index)
        if (!reader.holds(index)) return index;
      return {};
    };
    const std::optional<int> to_come = is_new_ || stops_ ? std::optional<int>() : ahead();
    if (to_come) return Task{*to_come, false};
    wake_.wait(lock, [&] { return stops_ || is_new_; });
    if (stops_) return {};
    is_new_ = false;
    continues = !before_ || *before_ < *requested_;
    return Task{std::clamp(*requested_, 0, reader.facts().frames() - 1), true};
  }

  void serve(VideoReader& reader) {
    int answered = -1;
    bool continues = true;
    while (const auto task = next_task(reader, answered, continues)) {
      auto frame = reader.frame(task->index, [this](double, std::string_view) { return !stops_; });
      if (stops_) return;
      if (!task->is_asked) {
        if (!frame) continues = false;  // reported on request
        continue;
      }
      answered = task->index;
      {
        const std::lock_guard lock(mutex_);
        trouble_ = frame ? Status(Done{}) : Status(frame.error());
        if (frame) newest_ = *frame;
      }
      tell();
    }
  }

  const std::filesystem::path file_;
  const std::function<void()> notify_;
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  State state_ = State::Opening;
  Status trouble_ = Done{};
  std::shared_ptr<const VideoFacts> facts_;
  VideoFramePtr newest_;
  std::optional<int> requested_, before_;
  bool is_new_ = false;
  std::atomic<bool> stops_ = false;
  std::atomic<double> opened_ = 0;
  std::thread thread_;
};

VideoDecoder::VideoDecoder(std::filesystem::path file, std::function<void()> notify)
    : work_(std::make_unique<Work>(std::move(file), std::move(notify))) {}
VideoDecoder::~VideoDecoder() = default;

VideoDecoder::State VideoDecoder::state() const {
  return work_->state();
}
double VideoDecoder::opened() const {
  return work_->opened();
}
Status VideoDecoder::trouble() const {
  return work_->trouble();
}
std::shared_ptr<const VideoFacts> VideoDecoder::facts() const {
  return work_->facts();
}
void VideoDecoder::request(int index) {
  work_->request(index);
}
VideoFramePtr VideoDecoder::newest() const {
  return work_->newest();
}
std::optional<int> VideoDecoder::requested() const {
  return work_->requested();
}

}  // namespace abrazo
