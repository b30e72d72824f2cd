#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/motion/body/clip.hpp"
#include "core/session/file/session_file.hpp"
#include "core/stream/net/udp_socket.hpp"
#include "core/stream/protocol/stream_encoder.hpp"
#include "tests/cli/command_line_fixture.hpp"
#include "tests/cli/udp_ports.hpp"

namespace abrazo::test {

using Bytes = std::vector<std::uint8_t>;

/// Looks until it is so; gives up only after a time that no machine needs.
bool wait_until(const std::function<bool()>& is_so);

/// "vmc://127.0.0.1:PORT?options"
std::string uri_of(const std::string& scheme, std::uint16_t port, const std::string& options = {});

/// Plays a clip to a port at about 60 Hz, with the program's own encoders. A port of its own each.
class TestSender {
 public:
  TestSender(const std::string& uri, const Clip& clip);

  /// The next frame, when it is due.
  void send_frame();
  /// Sends on until it is so. @return whether it came to that
  bool send_until(const std::function<bool()>& is_so);
  void send(const Bytes& bytes);
  /// The packets of the clip's next frame, not sent.
  std::vector<Bytes> next_packets();
  /// As a sender that was closed and opened again at the same port.
  void restart();

 private:
  using Clock = std::chrono::steady_clock;
  Endpoint to_;
  UdpSocket socket_;
  Clip clip_;
  std::unique_ptr<StreamEncoder> encoder_;
  std::size_t next_ = 0;
  Clock::time_point began_ = Clock::now(), due_ = Clock::now();
};

/// Takes what comes to a port of its own.
class TestReceiver {
 public:
  TestReceiver();
  std::uint16_t port() const { return socket_.local().port; }
  /// All that came so far.
  const std::vector<Bytes>& packets();

 private:
  SessionClock clock_;
  UdpSocket socket_;
  std::vector<Bytes> packets_;
};

/// `abrazo live` as a program, with a generated library, "demo.h5", and its clip to stream.
class LiveTest : public CommandLineTest {
 protected:
  LiveTest();
  ~LiveTest() override;

  /// Starts it with `--listen` and further words.
  void start(const std::string& listen, const std::string& words = {});
  /// The same, and waits until the port is open.
  void start_at(std::uint16_t port, const std::string& listen, const std::string& words = {});
  /// Ctrl-C, and the end.
  Outcome end();
  /// The same; its answer with --json.
  nlohmann::json statistics();
  bool has_warned_of(const std::string& part) const;

  const Clip& clip() const { return clip_; }
  std::shared_ptr<const SessionFile> session(const std::string& name) const;
  std::vector<FrameSnapshot> recorded_frames(const std::string& name) const;

  std::unique_ptr<RunningCommand> live;

 private:
  Clip clip_;
};

/// Of the entry with this kind in a list of issues or diagnoses; null when there is none.
nlohmann::json entry_of(const nlohmann::json& list, const std::string& kind);

}  // namespace abrazo::test
