#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace abrazo {

/// "vmc://HOST:PORT", "natnet://HOST[:PORT][?multicast=GROUP]", "xsens://HOST:PORT", "clip:FILE", each with
/// further options after "?" ("performer=Ana&delay=20"). The table of options is in stream_uri.cpp; an
/// unknown one is an error that lists those there are.
struct StreamUri {
  enum class Scheme { Vmc, NatNet, Xsens, Clip };
  Scheme scheme = Scheme::Vmc;
  /// Name or address: this machine's where none was written, "0.0.0.0" (every network) for "*".
  std::string host;
  std::uint16_t port = 0;  ///< the protocol's usual one where none was written
  std::string file;        ///< of a clip
  std::map<std::string, std::string, std::less<>> options;
  std::string text;  ///< as it was written

  std::string option(std::string_view key, std::string_view otherwise = {}) const;
};

/// What there is to know of a protocol, for the URI, for messages and for a list to choose from.
struct SchemeFacts {
  StreamUri::Scheme scheme = StreamUri::Scheme::Vmc;
  std::string_view word;     ///< of the URI
  std::string_view sender;   ///< whose packets they are
  std::string_view title;    ///< to choose it by
  std::uint16_t port = 0;    ///< the usual one; 0 = none
  bool asks_server = false;  ///< the host is a server that is asked, not an address that is listened at
};
/// In the order of Scheme.
std::span<const SchemeFacts> stream_schemes();
const SchemeFacts& facts_of(StreamUri::Scheme scheme);

/// The host where none is written.
inline constexpr std::string_view usual_stream_host = "127.0.0.1";

Result<StreamUri> parse_stream_uri(std::string_view text);

/// Who reaches a place that is listened at, such as "0.0.0.0:39539": "on this machine only
/// (127.0.0.1:39539)", "on every network (0.0.0.0:39539)" or "on the network of 192.168.1.7
/// (192.168.1.7:39539)".
std::string listening_words(std::string_view place);

enum class StreamDirection { Listen, Send };

/// An Error for an option that the other direction has; says which there are.
Status check_stream_options(const StreamUri& uri, StreamDirection direction);

/// An option in milliseconds, as seconds; nothing when it is not there.
Result<std::optional<double>> milliseconds_option(const StreamUri& uri, std::string_view key,
                                                  double largest_ms);

}  // namespace abrazo
