#include "widgets/stream/stream_address.hpp"

#include <array>
#include <cstdio>

namespace abrazo::widgets {
namespace {

/// An option value escaped for a URI.
std::string encoded(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    std::array<char, 4> code{};
    std::snprintf(code.data(), code.size(), "%%%02X", static_cast<unsigned char>(c));
    const bool is_special = std::string_view("%&=?+# ").find(c) != std::string_view::npos;
    plain += is_special ? std::string(code.data()) : std::string(1, c);
  }
  return plain;
}

}  // namespace

std::string uri_of(const StreamAddress& address) {
  const SchemeFacts& facts = facts_of(address.scheme);
  std::string uri = std::string(facts.word) + ":";
  if (address.scheme == StreamUri::Scheme::Clip) {
    uri += address.file;
  } else {
    uri += "//" + (address.host.empty() ? std::string(usual_stream_host) : address.host);
    uri += ":" + std::to_string(address.port == 0 ? facts.port : address.port);
  }
  auto options = address.options;
  if (!address.group.empty()) options["multicast"] = address.group;
  char before = '?';
  for (const auto& [key, value] : options) {
    uri += before + key + "=" + encoded(value);
    before = '&';
  }
  return uri;
}

std::string reach_of(const StreamAddress& address) {
  const SchemeFacts& facts = facts_of(address.scheme);
  if (address.scheme == StreamUri::Scheme::Clip) return {};
  const std::string host = address.host.empty() ? std::string(usual_stream_host) : address.host;
  const std::string place = host + ":" + std::to_string(address.port == 0 ? facts.port : address.port);
  const bool is_everywhere = host == "0.0.0.0" || host == "*";
  if (facts.asks_server)
    return is_everywhere ? "Asks no server; listens " + listening_words("0.0.0.0:1511")
                         : "Asks Motive at " + place + "; listens on the network that leads there";
  const std::string words = "Listens " + listening_words(place);
  return host.starts_with("127.") || host == "localhost" ? words + "; 0.0.0.0 is every network" : words;
}

Result<StreamAddress> address_of(std::string_view text) {
  const auto uri = parse_stream_uri(text);
  if (!uri) return uri.error();
  StreamAddress address{uri->scheme, uri->host, uri->port, uri->option("multicast"), uri->file, uri->options};
  address.options.erase("multicast");
  return address;
}

}  // namespace abrazo::widgets
