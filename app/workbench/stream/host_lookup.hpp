#pragma once

#include <QObject>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "core/base/result.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo::app {

/// Finds the addresses of the hosts that a stream's URI names, on a thread of its own: where no server
/// answers the system asks for many seconds, in which the window goes on. Never waits for one, not even at
/// its end.
class HostLookup : public QObject {
  Q_OBJECT
 public:
  /// The IPv4 address of a host, as the system's (core/stream/net/udp_socket.hpp). Called on another thread.
  using Resolve = std::function<Result<std::uint32_t>(const std::string& host)>;
  using Found = std::function<void(const Result<StreamUri>& uri)>;

  explicit HostLookup(QObject* parent = nullptr);
  HostLookup(Resolve resolve, QObject* parent);
  ~HostLookup() override;

  /// `found` is told the URI with addresses in the place of names: at once where it has no name, else later,
  /// on the thread of this object.
  void find(const StreamUri& uri, Found found);
  /// What was not found yet is not told any more.
  void cancel();

 private:
  /// Outlives this object as long as a thread still asks.
  struct Line {
    std::mutex mutex;
    HostLookup* end = nullptr;  ///< null once the result is not wanted
  };
  void begin();

  Resolve m_resolve;
  std::shared_ptr<Line> m_line;
};

}  // namespace abrazo::app
