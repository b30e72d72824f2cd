#include "core/stream/protocol/stream_uri.hpp"

#include <array>
#include <cctype>
#include <optional>
#include <vector>

#include "core/base/text.hpp"
#include "core/stream/net/usual_ports.hpp"

namespace abrazo {

namespace {

using Scheme = StreamUri::Scheme;

constexpr std::array schemes = {
    SchemeFacts{Scheme::Vmc, "vmc", "VMC", "VMC", vmc_port, false},
    SchemeFacts{Scheme::NatNet, "natnet", "NatNet", "NatNet (Motive)", natnet_command_port, true},
    SchemeFacts{Scheme::Xsens, "xsens", "Xsens MVN", "Xsens MVN", xsens_port, false},
    SchemeFacts{Scheme::Clip, "clip", "clip", "Clip, replayed", 0, false}};

constexpr bool is_in_order() {
  for (std::size_t i = 0; i < schemes.size(); ++i)
    if (static_cast<std::size_t>(schemes[i].scheme) != i) return false;
  return true;
}
static_assert(is_in_order());

/// An option with its valid schemes and meaning; messages show the text.
struct OptionFacts {
  std::string_view key;
  std::string_view schemes;  ///< names, separated by blanks
  bool listen, send;
  std::string_view meaning;
};

constexpr std::array option_table = {
    OptionFacts{"performer", "vmc natnet xsens", true, true,
                "performer=NAME (who is followed, or what is sent)"},
    OptionFacts{"delay", "vmc natnet xsens", true, false, "delay=MILLISECONDS (of the jitter buffer, 0-500)"},
    OptionFacts{"hold", "vmc natnet xsens", true, false,
                "hold=MILLISECONDS (how long a joint that is not tracked is held)"},
    OptionFacts{"map", "vmc natnet xsens", true, false, "map=NAME or FILE.json (joint map)"},
    OptionFacts{"floor", "vmc natnet xsens", true, false,
                "floor=METRES (height of the sender's floor) or auto"},
    OptionFacts{"unit", "vmc natnet", true, false, "unit=m|cm|mm or metres per unit"},
    OptionFacts{"up", "vmc natnet xsens", true, false, "up=y|z"},
    OptionFacts{"units", "xsens", true, false, "units=m|cm"},
    OptionFacts{"coordinates", "natnet", true, false, "coordinates=global|local"},
    OptionFacts{"multicast", "natnet", true, true, "multicast=GROUP"},
    OptionFacts{"interface", "natnet", true, true, "interface=ADDRESS (network that multicast goes through)"},
    OptionFacts{"version", "natnet", true, true, "version=3.0|3.1|4.0|4.1"},
    OptionFacts{"split", "vmc", true, false,
                "split=sender|port (each address is a performer, or all that comes to the port is one)"},
    OptionFacts{"framing", "vmc", false, true, "framing=t-last|t-first|split"},
    OptionFacts{"root", "vmc", false, true, "root=character|origin"},
    OptionFacts{"character", "xsens", false, true, "character=ID"},
};

bool names_scheme(const OptionFacts& option, Scheme scheme) {
  for (const std::string_view name : split_words(option.schemes))
    if (name == facts_of(scheme).word) return true;
  return false;
}

/// The valid options, for an Error.
std::string possible_options(Scheme scheme, bool listen, bool send) {
  std::string list;
  for (const OptionFacts& option : option_table)
    if (names_scheme(option, scheme) && ((listen && option.listen) || (send && option.send)))
      list += (list.empty() ? "" : ", ") + std::string(option.meaning);
  return list.empty() ? "it has none" : "possible are " + list;
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// "a%20b+c" -> "a b c".
std::string decoded(std::string_view text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int high = text[i] == '%' && i + 2 < text.size() ? hex_digit(text[i + 1]) : -1;
    const int low = high >= 0 ? hex_digit(text[i + 2]) : -1;
    if (low >= 0) {
      plain += static_cast<char>(16 * high + low);
      i += 2;
    } else {
      plain += text[i] == '+' ? ' ' : text[i];
    }
  }
  return plain;
}

Status parse_options(std::string_view text, StreamUri& uri) {
  for (const std::string_view field : split_fields(text, '&')) {
    if (field.empty()) continue;
    const auto equals = field.find('=');
    const std::string key = lower_case(field.substr(0, equals));
    if (equals == std::string_view::npos || equals + 1 == field.size())
      return Error{"the option " + in_quotes(field) + " has no value; write KEY=VALUE", uri.text};
    const bool is_known = [&] {
      for (const OptionFacts& option : option_table)
        if (option.key == key && names_scheme(option, uri.scheme)) return true;
      return false;
    }();
    if (!is_known)
      return Error{"there is no option " + in_quotes(key) + " for " + std::string(facts_of(uri.scheme).word) +
                       "; " + possible_options(uri.scheme, true, true),
                   uri.text};
    if (!uri.options.emplace(key, decoded(field.substr(equals + 1))).second)
      return Error{"the option " + in_quotes(key) + " is given twice", uri.text};
  }
  return Done{};
}

Status parse_place(std::string_view place, StreamUri& uri) {
  while (place.ends_with('/')) place.remove_suffix(1);
  if (place.find('/') != std::string_view::npos)
    return Error{
        "an address ends with the port: write " + std::string(facts_of(uri.scheme).word) + "://HOST:PORT",
        uri.text};
  const auto colon = place.find(':');
  if (place.find('[') != std::string_view::npos ||
      (colon != std::string_view::npos && place.find(':', colon + 1) != std::string_view::npos))
    return Error{"IPv6 is not supported; write a name or an IPv4 address such as 192.168.1.7", uri.text};
  uri.host = std::string(place.substr(0, colon));
  // Packets from a network are accepted only on request.
  if (uri.host.empty()) uri.host = usual_stream_host;
  if (uri.host == "*") uri.host = "0.0.0.0";
  for (const char c : uri.host)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '-' && c != '_')
      return Error{in_quotes(uri.host) + " is neither a name nor an address", uri.text};
  uri.port = facts_of(uri.scheme).port;
  if (colon == std::string_view::npos) return Done{};
  const auto port = parse_integer(place.substr(colon + 1));
  if (!port || *port < 0 || *port > 65535)
    return Error{"the port is " + in_quotes(place.substr(colon + 1)) +
                     "; expected a number from 1 to 65535 (0 = any that is free)",
                 uri.text};
  uri.port = static_cast<std::uint16_t>(*port);
  return Done{};
}

constexpr std::string_view usage =
    "expected vmc://HOST:PORT, natnet://HOST[:PORT][?multicast=GROUP], xsens://HOST:PORT or clip:FILE";

}  // namespace

std::span<const SchemeFacts> stream_schemes() {
  return schemes;
}

const SchemeFacts& facts_of(StreamUri::Scheme scheme) {
  return schemes[static_cast<std::size_t>(scheme)];
}

std::string StreamUri::option(std::string_view key, std::string_view otherwise) const {
  const auto found = options.find(key);
  return found == options.end() ? std::string(otherwise) : found->second;
}

Result<StreamUri> parse_stream_uri(std::string_view text) {
  text = trimmed(text);
  StreamUri uri;
  uri.text = std::string(text);
  const auto colon = text.find(':');
  const SchemeFacts* facts = nullptr;
  for (const SchemeFacts& candidate : schemes)
    if (colon != std::string_view::npos && lower_case(text.substr(0, colon)) == candidate.word)
      facts = &candidate;
  if (!facts) return Error{in_quotes(text) + " is no stream; " + std::string(usage), ""};
  uri.scheme = facts->scheme;
  std::string_view rest = text.substr(colon + 1);
  if (uri.scheme == Scheme::Clip) {  // a file's name may have any character
    uri.file = std::string(rest);
    if (uri.file.empty()) return Error{"clip: is followed by a motion file; " + std::string(usage), uri.text};
    return uri;
  }
  if (!rest.starts_with("//")) return Error{std::string(usage), uri.text};
  rest.remove_prefix(2);
  const auto question = rest.find('?');
  if (const Status placed = parse_place(rest.substr(0, question), uri); !placed) return placed.error();
  if (question != std::string_view::npos)
    if (const Status parsed = parse_options(rest.substr(question + 1), uri); !parsed) return parsed.error();
  return uri;
}

namespace {

bool is_this_machine(std::string_view host) {
  return host == "localhost" || host.starts_with("127.");
}

}  // namespace

Status check_no_loop(const StreamUri& listen, const StreamUri& send) {
  const bool same_port = send.scheme == listen.scheme && send.port == listen.port && send.port != 0;
  if (!same_port || !(is_this_machine(send.host) || send.host == listen.host)) return Done{};
  return Error{"would come back as the user, since " + listen.text + " is listened to; send to another port",
               send.text};
}

std::string listening_words(std::string_view place) {
  const std::string_view host = place.substr(0, place.find(':'));
  const std::string reach = is_this_machine(host)              ? "on this machine only"
                            : host == "0.0.0.0" || host == "*" ? "on every network"
                                                               : "on the network of " + std::string(host);
  return reach + " (" + std::string(place) + ")";
}

Status check_stream_options(const StreamUri& uri, StreamDirection direction) {
  const bool listen = direction == StreamDirection::Listen;
  for (const auto& [key, value] : uri.options)
    for (const OptionFacts& option : option_table)
      if (option.key == key && names_scheme(option, uri.scheme) && !(listen ? option.listen : option.send))
        return Error{"the option " + in_quotes(key) + " is for " + (listen ? "sending" : "listening") + "; " +
                         possible_options(uri.scheme, listen, !listen),
                     uri.text};
  return Done{};
}

Result<std::optional<double>> milliseconds_option(const StreamUri& uri, std::string_view key,
                                                  double largest_ms) {
  if (!uri.options.contains(key)) return std::optional<double>();
  const auto value = parse_number(uri.option(key));
  if (!value || !(*value >= 0 && *value <= largest_ms))
    return Error{"the option " + in_quotes(key) + " is " + in_quotes(uri.option(key)) +
                     "; expected milliseconds from 0 to " + exact_text(largest_ms),
                 uri.text};
  return std::optional<double>(*value / 1000);
}

}  // namespace abrazo
