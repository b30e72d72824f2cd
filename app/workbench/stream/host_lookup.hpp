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

/// Resolves the host names of a stream's URI on a separate thread, because the system may take many seconds
/// if no server answers. Never waits for it, not even in the destructor.
class HostLookup : public QObject {
  Q_OBJECT
 public:
  /// Resolves a host to an IPv4 address, see core/stream/net/udp_socket.hpp. Called on another thread.
  using Resolve = std::function<Result<std::uint32_t>(const std::string& host)>;
  using Found = std::function<void(const Result<StreamUri>& uri)>;

  explicit HostLookup(QObject* parent = nullptr);
  HostLookup(Resolve resolve, QObject* parent);
  ~HostLookup() override;

  /// Calls `found` with the URI, names replaced by addresses: at once if it has no name, else later on the
  /// thread of this object.
  void find(const StreamUri& uri, Found found);
  /// Drops pending results.
  void cancel();

 private:
  /// Shared with running threads, so that it outlives this object.
  struct Line {
    std::mutex mutex;
    HostLookup* end = nullptr;  ///< null = the result is dropped
  };
  void begin();

  Resolve m_resolve;
  std::shared_ptr<Line> m_line;
};

}  // namespace abrazo::app
