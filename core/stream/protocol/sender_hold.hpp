#pragma once

#include <cstdint>
#include <optional>

#include "core/stream/net/datagram.hpp"

namespace abrazo {

/// Whose packets count where every machine may send: those of the one that came first, until nothing useful
/// has come from it for a while. An address and not a port: some senders take another port for each packet.
class SenderHold {
 public:
  /// Longer than a gap of a sender that lives, shorter than its user would wait after a restart elsewhere
  /// [s].
  static constexpr double released_after_s = 1;

  enum class Answer { Holder, NewHolder, Refused };
  /// Whether a packet from there counts. Who comes first, or after a silence of the holder, is the holder.
  Answer claim(const Endpoint& from, double at_s) {
    if (address_ == from.address) return Answer::Holder;
    if (address_ && at_s - useful_s_ <= released_after_s) return Answer::Refused;
    address_ = from.address;
    useful_s_ = at_s;
    return Answer::NewHolder;
  }
  bool is_holder(const Endpoint& from) const { return address_ == from.address; }
  /// The holder sent what it is heard for.
  void sent_something_useful(double at_s) { useful_s_ = at_s; }
  std::optional<std::uint32_t> address() const { return address_; }

 private:
  std::optional<std::uint32_t> address_;
  double useful_s_ = 0;
};

}  // namespace abrazo
