#pragma once

#include <cstdint>
#include <optional>

#include "core/stream/net/datagram.hpp"

namespace abrazo {

/// Selects the sender whose packets count if every machine may send: the first, until it has sent nothing
/// useful for a while. Identified by address, not port: some senders use another port for each packet.
class SenderHold {
 public:
  /// Longer than gaps of an active sender, shorter than a user waits after a restart on another machine [s].
  static constexpr double released_after_s = 1;

  enum class Answer { Holder, NewHolder, Refused };
  /// Whether a packet from there counts. The first sender, or the first after the holder's silence, becomes
  /// the holder.
  Answer claim(const Endpoint& from, double at_s) {
    if (address_ == from.address) return Answer::Holder;
    if (address_ && at_s - useful_s_ <= released_after_s) return Answer::Refused;
    address_ = from.address;
    useful_s_ = at_s;
    return Answer::NewHolder;
  }
  bool is_holder(const Endpoint& from) const { return address_ == from.address; }
  /// Reports useful data from the holder.
  void sent_something_useful(double at_s) { useful_s_ = at_s; }
  std::optional<std::uint32_t> address() const { return address_; }

 private:
  std::optional<std::uint32_t> address_;
  double useful_s_ = 0;
};

}  // namespace abrazo
