#include "core/stream/receive/stream_receiver.hpp"

#include <map>
#include <mutex>
#include <stop_token>
#include <thread>

#include "core/base/thread_urgency.hpp"
#include "core/stream/receive/decoders.hpp"
#include "core/stream/receive/pose_reader.hpp"
#include "core/stream/receive/stream_pipeline.hpp"
#include "core/stream/receive/stream_sockets.hpp"

namespace abrazo {

namespace {

/// Short enough for the decoders' silences (8 ms) to be noticed in time.
constexpr int longest_sleep_ms = 4;
constexpr double between_network_looks_s = 1;
constexpr double usual_packet_s = 3e-4;  ///< most take less, with all that is told of them

/// Functions to be called, with numbers to take them away by. When `remove` has returned, none is running.
template <typename... Arguments>
class Listeners {
 public:
  int add(std::function<void(Arguments...)> listener) {
    const std::scoped_lock lock(mutex_);
    listeners_.emplace(++last_, std::move(listener));
    return last_;
  }
  void remove(int number) {
    const std::scoped_lock lock(mutex_);
    listeners_.erase(number);
  }
  void call(const Arguments&... arguments) {
    const std::scoped_lock lock(mutex_);
    for (const auto& [number, listener] : listeners_) listener(arguments...);
  }

 private:
  std::mutex mutex_;
  std::map<int, std::function<void(Arguments...)>> listeners_;
  int last_ = 0;
};

/// What receiver and sources share; sources may outlive the receiver.
struct SharedStream {
  SharedStream(StreamPipeline stream, SessionClock session_clock)
      : pipeline(std::move(stream)), clock(session_clock) {}
  mutable std::mutex mutex;
  std::mutex handing_out;   ///< held from counting a pose until all listeners have it; locked before `mutex`
  StreamPipeline pipeline;  ///< guarded by `mutex`
  SessionClock clock;
  Listeners<const ReceivedPose&> taps;
  Listeners<> arrivals;
};

class LiveSource : public PoseSource {
 public:
  LiveSource(std::shared_ptr<SharedStream> stream, std::string performer)
      : stream_(std::move(stream)), reader_(std::move(performer)) {}
  ~LiveSource() override { stop_telling(); }

  std::optional<SourcePose> poll(double now_s) override {
    const std::scoped_lock lock(stream_->mutex);
    return reader_.poll(stream_->pipeline, now_s);
  }
  double next_due_s() const override {
    const std::scoped_lock lock(stream_->mutex);
    return reader_.next_due_s(stream_->pipeline);
  }
  double rate_hz() const override {
    const std::scoped_lock lock(stream_->mutex);
    return reader_.rate_hz(stream_->pipeline);
  }
  void set_max_rate(double max_rate_hz) override {
    const std::scoped_lock lock(stream_->mutex);
    reader_.set_max_rate(max_rate_hz);
  }
  std::optional<Body> body() const override {
    const std::scoped_lock lock(stream_->mutex);
    const PerformerStream* const followed = stream_->pipeline.find(reader_.performer());
    return followed ? followed->body() : std::nullopt;
  }
  void on_arrival(std::function<void()> called) override {
    stop_telling();
    if (called) number_ = stream_->arrivals.add(std::move(called));
  }

 private:
  void stop_telling() {
    if (number_ != 0) stream_->arrivals.remove(number_);
    number_ = 0;
  }
  std::shared_ptr<SharedStream> stream_;
  PoseReader reader_;  ///< guarded by the stream's mutex
  int number_ = 0;
};

class UdpStreamReceiver : public StreamReceiver {
 public:
  UdpStreamReceiver(StreamUri uri, StreamSockets sockets, std::shared_ptr<SharedStream> stream)
      : uri_(std::move(uri)), sockets_(std::move(sockets)), stream_(std::move(stream)) {}
  ~UdpStreamReceiver() override {
    thread_.request_stop();
    sockets_.wake();
    if (thread_.joinable()) thread_.join();
  }
  UdpStreamReceiver(const UdpStreamReceiver&) = delete;
  UdpStreamReceiver& operator=(const UdpStreamReceiver&) = delete;

  /// What has come to the port meanwhile is taken first.
  void start() {
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }

  const StreamUri& uri() const override { return uri_; }
  StreamHealth health() const override {
    const std::scoped_lock lock(stream_->mutex);
    return stream_->pipeline.health(stream_->clock.now_s());
  }
  std::vector<std::string> performers() const override {
    const std::scoped_lock lock(stream_->mutex);
    return stream_->pipeline.performers();
  }
  std::unique_ptr<PoseSource> source(const std::string& performer) override {
    return std::make_unique<LiveSource>(stream_, performer.empty() ? uri_.option("performer") : performer);
  }
  int listen(std::function<void(const ReceivedPose&)> listener) override {
    return stream_->taps.add(std::move(listener));
  }
  void unlisten(int number) override {
    const std::scoped_lock handing_out(stream_->handing_out);
    stream_->taps.remove(number);
  }
  void set_delay(double delay_s) override {
    const std::scoped_lock lock(stream_->mutex);
    stream_->pipeline.set_delay(delay_s);
  }
  void calibrate(const std::string& performer, double over_s) override {
    const std::scoped_lock lock(stream_->mutex);
    stream_->pipeline.calibrate(performer, over_s, stream_->clock.now_s());
  }
  std::optional<Body> measured_body(const std::string& performer) const override {
    const std::scoped_lock lock(stream_->mutex);
    const PerformerStream* const stream = stream_->pipeline.find(performer);
    return stream ? stream->body() : std::nullopt;
  }

 private:
  void run(const std::stop_token& stop);
  void take_packets();
  void pass_time();
  void look_at_network();
  void hand_out(StreamPipeline::Output& output);

  StreamUri uri_;
  StreamSockets sockets_;  ///< used by the thread, but for `wake`
  std::shared_ptr<SharedStream> stream_;
  bool is_broken_ = false;
  double looked_at_network_s_ = 0;
  std::jthread thread_;  // declared after the objects it uses
};

void UdpStreamReceiver::run(const std::stop_token& stop) {
  let_this_thread_go_first(usual_packet_s);
  double passed_s = stream_->clock.now_s();
  while (!stop.stop_requested()) {
    const bool came = sockets_.wait(longest_sleep_ms);
    if (is_broken_)
      std::this_thread::sleep_for(std::chrono::milliseconds(longest_sleep_ms));
    else if (came)
      take_packets();
    const double now_s = stream_->clock.now_s();
    if (now_s - passed_s < 1e-3 * (longest_sleep_ms - 1)) continue;
    passed_s = now_s;
    pass_time();
  }
}

void UdpStreamReceiver::take_packets() {
  using Packet = StreamSockets::Packet;
  const Status received = sockets_.receive(stream_->clock, [this](const Datagram& datagram, Packet packet) {
    StreamPipeline::Output output;
    const std::scoped_lock handing_out(stream_->handing_out);
    {
      const std::scoped_lock lock(stream_->mutex);
      if (packet == Packet::OfAStranger)
        stream_->pipeline.note_stranger(datagram.from, sockets_.server(), stream_->clock.now_s());
      else
        stream_->pipeline.take(datagram, stream_->clock.now_s(), output, packet == Packet::Truncated);
    }
    hand_out(output);
  });
  if (received) return;
  is_broken_ = true;
  const std::scoped_lock lock(stream_->mutex);
  stream_->pipeline.note_failure(received.error().text());
}

void UdpStreamReceiver::pass_time() {
  StreamPipeline::Output output;
  const std::scoped_lock handing_out(stream_->handing_out);
  {
    const std::scoped_lock lock(stream_->mutex);
    stream_->pipeline.pass_time(stream_->clock.now_s(), output);
    stream_->pipeline.note_overflow(sockets_.overflowed(), stream_->clock.now_s());
    if (const auto group = stream_->pipeline.wanted_group()) {
      const Status joined = sockets_.join(*group);
      stream_->pipeline.note_group_failure(joined ? std::string() : joined.error().text());
      stream_->pipeline.note_listening(sockets_.listening());
    }
  }
  hand_out(output);
  if (const double now_s = stream_->clock.now_s(); now_s - looked_at_network_s_ >= between_network_looks_s) {
    looked_at_network_s_ = now_s;
    look_at_network();
  }
}

void UdpStreamReceiver::look_at_network() {
  const std::string listening = sockets_.listening(), lost = sockets_.lost_address();
  const std::scoped_lock lock(stream_->mutex);
  stream_->pipeline.note_listening(listening);
  stream_->pipeline.note_lost_address(lost);
}

void UdpStreamReceiver::hand_out(StreamPipeline::Output& output) {
  for (const OutgoingDatagram& reply : output.replies) {
    const Status sent = sockets_.reply(reply);
    if (sent) continue;
    const std::scoped_lock lock(stream_->mutex);
    stream_->pipeline.note_issue({"reply-failed", sent.error().text()});
  }
  for (const ReceivedPose& pose : output.poses) stream_->taps.call(pose);
  if (!output.poses.empty()) stream_->arrivals.call();
}

}  // namespace

Result<std::shared_ptr<StreamReceiver>> StreamReceiver::open(const StreamUri& uri, const SessionClock& clock,
                                                             const StreamReceiverOptions& options) {
  Result<std::unique_ptr<StreamDecoder>> decoder = make_stream_decoder(uri);
  if (!decoder) return decoder.error();
  return open(uri, clock, options, std::move(*decoder));
}

Result<std::shared_ptr<StreamReceiver>> StreamReceiver::open(const StreamUri& uri, const SessionClock& clock,
                                                             const StreamReceiverOptions& options,
                                                             std::unique_ptr<StreamDecoder> decoder) {
  Result<PerformerStream::Options> performer = performer_options(uri, options);
  if (!performer) return performer.error();
  Result<StreamSockets> sockets = StreamSockets::open(uri);
  if (!sockets) return sockets.error();
  auto stream = std::make_shared<SharedStream>(
      StreamPipeline(std::move(decoder), uri, std::move(*performer), clock.now_s()), clock);
  stream->pipeline.note_listening(sockets->listening());
  auto receiver = std::make_shared<UdpStreamReceiver>(uri, std::move(*sockets), std::move(stream));
  if (options.prepare) options.prepare(*receiver);
  receiver->start();
  return std::shared_ptr<StreamReceiver>(std::move(receiver));
}

}  // namespace abrazo
