#include "core/stream/vmc/osc_packet.hpp"

#include <lo/lo.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace abrazo {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::string_view bundle_mark("#bundle\0", 8);
constexpr std::size_t bundle_head = 16;  ///< mark and time tag [bytes]
constexpr std::size_t longest_quote = 40;

struct FreeMessage {
  void operator()(lo_message message) const { lo_message_free(message); }
};
using Message = std::unique_ptr<std::remove_pointer_t<lo_message>, FreeMessage>;

std::uint32_t big_endian_u32(Bytes bytes, std::size_t at) {
  return std::uint32_t{bytes[at]} << 24U | std::uint32_t{bytes[at + 1]} << 16U |
         std::uint32_t{bytes[at + 2]} << 8U | std::uint32_t{bytes[at + 3]};
}

/// A value that liblo has put into the machine's byte order, though not on a boundary of its size.
template <typename T>
T value_at(const lo_arg* argument) {
  T value;
  std::memcpy(&value, argument, sizeof value);
  return value;
}

OscArgument argument_of(char type, const lo_arg* argument) {
  switch (type) {
    case LO_INT32:
      return {type, static_cast<double>(value_at<std::int32_t>(argument)), {}};
    case LO_INT64:
      return {type, static_cast<double>(value_at<std::int64_t>(argument)), {}};
    case LO_FLOAT:
      return {type, static_cast<double>(value_at<float>(argument)), {}};
    case LO_DOUBLE:
      return {type, value_at<double>(argument), {}};
    case LO_TRUE:
      return {type, 1, {}};
    case LO_STRING:
    case LO_SYMBOL:
      return {type, 0, reinterpret_cast<const char*>(argument)};
    default:
      return {type, 0, {}};
  }
}

/// Length of a string with its NUL and the padding to 4 bytes; 0 when it does not end within `bytes`.
std::size_t padded_length(Bytes bytes) {
  const auto end = std::find(bytes.begin(), bytes.end(), std::uint8_t{0});
  const std::size_t length = 4 * (static_cast<std::size_t>(end - bytes.begin()) / 4 + 1);
  return end == bytes.end() || length > bytes.size() ? 0 : length;
}

/// Size of an argument; none if it exceeds `bytes`, or the type is unknown.
std::optional<std::size_t> argument_length(char type, Bytes bytes) {
  std::size_t length = 0;
  if (std::string_view("ifcrm").find(type) != std::string_view::npos) {
    length = 4;
  } else if (std::string_view("hdt").find(type) != std::string_view::npos) {
    length = 8;
  } else if (type == 's' || type == 'S') {
    length = padded_length(bytes);
    if (length == 0) return std::nullopt;
  } else if (type == 'b') {
    if (bytes.size() < 4) return std::nullopt;
    length = 4 + (std::size_t{big_endian_u32(bytes, 0)} + 3) / 4 * 4;
  } else if (std::string_view("TFNI").find(type) == std::string_view::npos) {
    return std::nullopt;
  }
  return length <= bytes.size() ? std::optional(length) : std::nullopt;
}

/// Why the arguments do not match the type tags; empty if they do. liblo reads the length of a blob before it
/// checks whether there is one.
std::string argument_fault(Bytes message) {
  const std::size_t address = padded_length(message);
  if (address == 0 || address == message.size()) return {};  // liblo reports it
  const Bytes tags = message.subspan(address);
  const std::size_t tags_length = padded_length(tags);
  if (tags_length == 0 || tags[0] != ',') return {};
  Bytes rest = tags.subspan(tags_length);
  for (std::size_t i = 1; tags[i] != 0; ++i) {
    const char type = static_cast<char>(tags[i]);
    const auto length = argument_length(type, rest);
    if (!length)
      return "argument " + std::to_string(i) + " is cut off, or its type tag (number " +
             std::to_string(tags[i]) + ") is none of OSC 1.0";
    rest = rest.subspan(*length);
  }
  return rest.empty() ? std::string()
                      : std::to_string(rest.size()) + " bytes are left behind the last argument";
}

/// Meaning of an error number of liblo, with the requirement of OSC.
std::string message_fault(int code) {
  switch (code) {
    case LO_EINVALIDPATH:
      return "the address is not a string that ends in NUL and is filled up with NUL to 4 bytes";
    case LO_ENOTYPE:
      return "there is no string of type tags behind the address";
    case LO_EINVALIDTYPE:
      return "the string of type tags does not end in NUL or is not filled up with NUL to 4 bytes";
    case LO_EBADTYPE:
      return "the string of type tags does not begin with ','";
    case LO_EINVALIDARG:
      return "a string or blob among its arguments is not filled up with NUL to 4 bytes";
    default:
      return "it cannot be read (liblo's error " + std::to_string(code) + ")";
  }
}

class Reader {
 public:
  explicit Reader(Bytes packet) : packet_(packet) {}

  OscPacket read() {
    if (packet_.empty())
      issue("truncated", 0, "the packet is empty; expected an OSC message or bundle");
    else if (packet_[0] != '/' && packet_[0] != '#')
      issue(
          "not-osc", 0,
          "the packet does not begin with '/' (a message) or '#bundle'; the sender speaks another protocol");
    else
      element(0, packet_.size(), 1);
    return std::move(result_);
  }

 private:
  void issue(std::string kind, std::size_t offset, const std::string& text) {
    if (result_.issues.size() >= most_osc_issues) return;
    result_.issues.push_back({std::move(kind), offset, "byte " + std::to_string(offset) + ": " + text});
  }

  void element(std::size_t begin, std::size_t end, int depth) {
    if (packet_[begin] == '#')
      bundle(begin, end, depth);
    else
      message(begin, end);
  }

  void bundle(std::size_t begin, std::size_t end, int depth) {
    if (end - begin < bundle_head) {
      issue("truncated", begin,
            "a bundle of " + std::to_string(end - begin) + " bytes; its head alone has 16");
      return;
    }
    if (std::memcmp(packet_.data() + begin, bundle_mark.data(), bundle_mark.size()) != 0) {
      issue("not-osc", begin, "begins with '#' but not with '#bundle'");
      return;
    }
    if (depth > deepest_osc_bundle) {
      issue("bad-bundle", begin,
            "bundles within bundles, more than " + std::to_string(deepest_osc_bundle) + " deep");
      return;
    }
    OscElement first = osc_bundle_begin(std::uint64_t{big_endian_u32(packet_, begin + 8)} << 32U |
                                        big_endian_u32(packet_, begin + 12));
    first.offset = begin;
    result_.elements.push_back(std::move(first));
    contents(begin + bundle_head, end, depth);
    result_.elements.push_back(osc_bundle_end());
    result_.elements.back().offset = end;
  }

  void contents(std::size_t at, std::size_t end, int depth) {
    while (at < end) {
      if (end - at < 4) {
        issue("truncated", at,
              std::to_string(end - at) + " bytes are left where a length of 4 bytes is expected");
        return;
      }
      const std::size_t length = big_endian_u32(packet_, at);
      at += 4;
      if (length > end - at) {
        issue("truncated", at - 4,
              "an element of " + std::to_string(length) + " bytes in the " + std::to_string(end - at) +
                  " that are left; the packet was cut off, or the length is wrong");
        return;
      }
      if (length == 0 || length % 4 != 0)
        issue("bad-bundle", at - 4,
              "an element of " + std::to_string(length) + " bytes; expected a multiple of 4 above 0");
      else
        element(at, at + length, depth + 1);
      at += length;
    }
  }

  void message(std::size_t begin, std::size_t end) {
    if (packet_[begin] != '/') {
      issue("bad-message", begin, "an element begins neither with '/' nor with '#bundle'");
      return;
    }
    // liblo wants to write where it reads only in its signature.
    auto* const data = const_cast<std::uint8_t*>(packet_.data() + begin);
    const std::string address(reinterpret_cast<const char*>(data), text_length(begin, end));
    int code = 0;
    std::string fault = argument_fault(packet_.subspan(begin, end - begin));
    const Message read(fault.empty() ? lo_message_deserialise(data, end - begin, &code) : nullptr);
    if (!read) {
      if (fault.empty()) fault = message_fault(code);
      issue("bad-message", begin, "message " + address.substr(0, longest_quote) + ": " + fault);
      return;
    }
    OscElement element = osc_message(address, {});
    element.offset = begin;
    const std::string_view types(lo_message_get_types(read.get()));
    lo_arg* const* arguments = lo_message_get_argv(read.get());
    for (std::size_t i = 0; i < types.size(); ++i)
      element.arguments.push_back(argument_of(types[i], arguments[i]));
    result_.elements.push_back(std::move(element));
  }

  std::size_t text_length(std::size_t begin, std::size_t end) const {
    const auto first = packet_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = packet_.begin() + static_cast<std::ptrdiff_t>(end);
    return static_cast<std::size_t>(std::find(first, last, std::uint8_t{0}) - first);
  }

  Bytes packet_;
  OscPacket result_;
};

lo_message new_message(const OscElement& element) {
  lo_message message = lo_message_new();
  for (const OscArgument& argument : element.arguments) {
    switch (argument.type) {
      case LO_INT32:
        lo_message_add_int32(message, static_cast<std::int32_t>(argument.number));
        break;
      case LO_DOUBLE:
        lo_message_add_double(message, argument.number);
        break;
      case LO_STRING:
        lo_message_add_string(message, argument.text.c_str());
        break;
      case LO_FLOAT:
        lo_message_add_float(message, static_cast<float>(argument.number));
        break;
      default:
        lo_message_free(message);
        throw std::invalid_argument(std::string("write_osc: no arguments of type '") + argument.type + "'");
    }
  }
  return message;
}

struct FreeBundle {
  void operator()(lo_bundle bundle) const { lo_bundle_free_recursive(bundle); }
};
using Bundle = std::unique_ptr<std::remove_pointer_t<lo_bundle>, FreeBundle>;

/// The bundle that begins at `at`; moves `at` behind its end.
Bundle new_bundle(std::span<const OscElement> elements, std::size_t& at) {
  const std::uint64_t tag = elements[at++].time_tag;
  Bundle bundle(
      lo_bundle_new(lo_timetag{static_cast<std::uint32_t>(tag >> 32U), static_cast<std::uint32_t>(tag)}));
  for (; at < elements.size(); ++at) {
    const OscElement& element = elements[at];
    if (element.kind == OscElement::Kind::BundleEnd) return ++at, std::move(bundle);
    if (element.kind == OscElement::Kind::BundleBegin) {
      lo_bundle_add_bundle(bundle.get(), new_bundle(elements, at).release());
      --at;
    } else {
      lo_bundle_add_message(bundle.get(), element.address.c_str(), new_message(element));
    }
  }
  throw std::invalid_argument("write_osc: a bundle without end");
}

}  // namespace

OscPacket read_osc(std::span<const std::uint8_t> bytes) {
  return Reader(bytes).read();
}

std::vector<std::uint8_t> write_osc(std::span<const OscElement> elements) {
  if (elements.empty() || elements[0].kind == OscElement::Kind::BundleEnd)
    throw std::invalid_argument("write_osc: expected a message or a bundle");
  std::size_t at = 0;
  std::vector<std::uint8_t> bytes;
  if (elements[0].kind == OscElement::Kind::Message) {
    const Message message(new_message(elements[at++]));
    bytes.resize(lo_message_length(message.get(), elements[0].address.c_str()));
    lo_message_serialise(message.get(), elements[0].address.c_str(), bytes.data(), nullptr);
  } else {
    const Bundle bundle = new_bundle(elements, at);
    bytes.resize(lo_bundle_length(bundle.get()));
    lo_bundle_serialise(bundle.get(), bytes.data(), nullptr);
  }
  if (at != elements.size()) throw std::invalid_argument("write_osc: more than one message or bundle");
  return bytes;
}

OscElement osc_message(std::string address, std::vector<OscArgument> arguments) {
  return {OscElement::Kind::Message, 0, 0, std::move(address), std::move(arguments)};
}

OscElement osc_bundle_begin(std::uint64_t time_tag) {
  return {OscElement::Kind::BundleBegin, 0, time_tag, {}, {}};
}

OscElement osc_bundle_end() {
  return {OscElement::Kind::BundleEnd, 0, 0, {}, {}};
}

}  // namespace abrazo
