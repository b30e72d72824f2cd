#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.hpp"

namespace abrazo {

/// "vmc://HOST:PORT", "natnet://HOST[:PORT][?multicast=GROUP]", "xsens://HOST:PORT", "clip:FILE", each with
/// further options after "?" ("performer=Ana&delay=20"). The table of options is in stream_uri.cpp; an
/// unknown one is an Error that lists the valid ones.
struct StreamUri {
  enum class Scheme { Vmc, NatNet, Xsens, Clip };
  Scheme scheme = Scheme::Vmc;
  /// Name or address: this machine if not given, "0.0.0.0" (every network) for "*".
  std::string host;
  std::uint16_t port = 0;  ///< the protocol's default if not given
  std::string file;        ///< of a clip
  std::map<std::string, std::string, std::less<>> options;
  std::string text;  ///< the original text

  std::string option(std::string_view key, std::string_view otherwise = {}) const;
};

/// What there is to know of a protocol, for the URI, for messages and for a list to choose from.
struct SchemeFacts {
  StreamUri::Scheme scheme = StreamUri::Scheme::Vmc;
  std::string_view word;     ///< of the URI
  std::string_view sender;   ///< name of the protocol in messages; text of `protocol_of` starts with it
  std::string_view title;    ///< to choose it by
  std::uint16_t port = 0;    ///< the usual one; 0 = none
  bool asks_server = false;  ///< the host is a server that sends on request, not an address of this machine
};
/// In the order of Scheme.
std::span<const SchemeFacts> stream_schemes();
const SchemeFacts& facts_of(StreamUri::Scheme scheme);

/// The host where none is written.
inline constexpr std::string_view usual_stream_host = "127.0.0.1";

Result<StreamUri> parse_stream_uri(std::string_view text);

/// Machines that can send to a listening address, such as "0.0.0.0:39539": "on this machine only
/// (127.0.0.1:39539)", "on every network (0.0.0.0:39539)" or "on the network of 192.168.1.7
/// (192.168.1.7:39539)".
std::string listening_words(std::string_view place);

enum class StreamDirection { Listen, Send };

/// An Error for an option of the other direction; lists the valid ones.
Status check_stream_options(const StreamUri& uri, StreamDirection direction);

/// An Error if what is sent there would be received again as the user: the same protocol and port on this
/// machine.
Status check_no_loop(const StreamUri& listen, const StreamUri& send);

/// An option in milliseconds, as seconds; none if it is not given.
Result<std::optional<double>> milliseconds_option(const StreamUri& uri, std::string_view key,
                                                  double largest_ms);

}  // namespace abrazo
