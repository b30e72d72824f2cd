#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "core/base/result.hpp"
#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo::widgets {

/// A stream's URI in the fields of a form.
struct StreamAddress {
  StreamUri::Scheme scheme = StreamUri::Scheme::Vmc;
  std::string host;                                         ///< empty = default
  int port = 0;                                             ///< 0 = default
  std::string group;                                        ///< NatNet only; empty = unicast
  std::string file;                                         ///< of a clip
  std::map<std::string, std::string, std::less<>> options;  ///< other options, as written
};

/// "vmc://127.0.0.1:39539", with defaults for empty fields.
std::string uri_of(const StreamAddress& address);
/// The accepted senders: "Listens on this machine only (127.0.0.1:39539); 0.0.0.0 is every network".
std::string reach_of(const StreamAddress& address);
/// The Error says what is wrong with the text.
Result<StreamAddress> address_of(std::string_view uri);

}  // namespace abrazo::widgets
