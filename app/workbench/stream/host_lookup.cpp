#include "app/workbench/stream/host_lookup.hpp"

#include <QMetaObject>
#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

#include "core/stream/net/datagram.hpp"
#include "core/stream/net/udp_socket.hpp"

namespace abrazo::app {
namespace {

/// Needs no look-up: an address, or empty.
bool is_plain(const std::string& host) {
  return std::all_of(host.begin(), host.end(), [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
}

/// Where hosts may be named, of those that `uri` has.
std::vector<std::string*> hosts_of(StreamUri& uri) {
  std::vector<std::string*> hosts{&uri.host};
  for (const char* option : {"interface", "multicast"})
    if (const auto found = uri.options.find(option); found != uri.options.end())
      hosts.push_back(&found->second);
  std::erase_if(hosts, [](const std::string* host) { return is_plain(*host); });
  return hosts;
}

Result<StreamUri> resolved(StreamUri uri, const HostLookup::Resolve& resolve) {
  for (std::string* host : hosts_of(uri)) {
    const Result<std::uint32_t> address = resolve(*host);
    if (!address) return address.error();
    *host = Endpoint{*address, 0}.text();
    host->resize(host->rfind(':'));
  }
  return uri;
}

}  // namespace

HostLookup::HostLookup(QObject* parent) : HostLookup(resolve_host, parent) {}

HostLookup::HostLookup(Resolve resolve, QObject* parent) : QObject(parent), m_resolve(std::move(resolve)) {
  begin();
}

HostLookup::~HostLookup() {
  cancel();
}

void HostLookup::begin() {
  m_line = std::make_shared<Line>();
  m_line->end = this;
}

void HostLookup::cancel() {
  {
    const std::scoped_lock lock(m_line->mutex);
    m_line->end = nullptr;
  }
  begin();
}

void HostLookup::find(const StreamUri& uri, Found found) {
  StreamUri asked = uri;
  if (uri.scheme == StreamUri::Scheme::Clip || hosts_of(asked).empty()) return found(uri);
  // Not joined: the system's question cannot be taken back.
  std::thread([asked, resolve = m_resolve, line = m_line, found = std::move(found)] {
    const Result<StreamUri> answer = resolved(asked, resolve);
    const std::scoped_lock lock(line->mutex);
    if (!line->end) return;
    QMetaObject::invokeMethod(
        line->end,
        [line, answer, found] {
          if (line->end) found(answer);  // it may have been cancelled since
        },
        Qt::QueuedConnection);
  }).detach();
}

}  // namespace abrazo::app
