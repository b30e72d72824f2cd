#include "core/stream/vmc/vmc_decoder.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "core/base/text.hpp"
#include "core/stream/vmc/vmc_performer.hpp"

namespace abrazo {

namespace {

/// More senders at once than a stage has people: a program that takes another port for every packet.
constexpr std::size_t most_vmc_senders = 16;
/// A sender without packets, or without poses, for this time makes room for another [s].
constexpr double forgotten_sender_s = 2, no_pose_for_s = 1;
constexpr std::size_t most_issues_per_packet = 32;
constexpr const char* shared_name = "all senders";

class VmcDecoder : public StreamDecoder {
 public:
  explicit VmcDecoder(bool splits_by_sender) : splits_by_sender_(splits_by_sender) {}

  void take(const Datagram& datagram, Decoded& out) override {
    const std::size_t issues_before = out.issues.size();
    const OscPacket packet = read_osc(datagram.bytes);
    for (const OscIssue& issue : packet.issues) out.issues.push_back({issue.kind, issue.text});
    if (!packet.elements.empty())
      if (VmcPerformer* const performer = performer_of(datagram, out)) performer->take(packet, datagram, out);
    if (out.issues.size() > issues_before + most_issues_per_packet)
      out.issues.resize(issues_before + most_issues_per_packet);
  }

  void pass_time(double now_s, Decoded& out) override {
    for (const auto& performer : performers_) performer->pass_time(now_s, out);
  }

  void calibrate(const std::string& performer) override {
    for (const auto& known : performers_)
      if (performer.empty() || known->name() == performer) known->calibrate();
  }

  std::vector<std::string> facts() const override {
    std::vector<std::string> facts;
    for (const auto& performer : performers_) facts.push_back(performer->facts());
    return facts;
  }

 private:
  /// Null if there is no room: a new sender does not replace one that sends poses now.
  VmcPerformer* performer_of(const Datagram& datagram, Decoded& out) {
    const std::string name = splits_by_sender_ ? datagram.from.text() : shared_name;
    for (const auto& performer : performers_)
      if (performer->name() == name) return performer.get();
    if (performers_.size() >= most_vmc_senders) {
      const double now_s = datagram.arrived_s;
      const auto idle =
          std::find_if(performers_.begin(), performers_.end(), [&](const std::unique_ptr<VmcPerformer>& one) {
            return now_s - one->last_s() > forgotten_sender_s ||
                   (one->frames() == 0 && now_s - one->first_s() > no_pose_for_s);
          });
      if (idle == performers_.end()) {
        out.issues.push_back(
            {"many-senders",
             "more than " + std::to_string(most_vmc_senders) + " addresses send here; " + name +
                 " is left out until another one falls silent. A program that takes another port for every "
                 "packet is one performer with the option split=port"});
        return nullptr;
      }
      performers_.erase(idle);
    }
    performers_.push_back(std::make_unique<VmcPerformer>(name));
    return performers_.back().get();
  }

  bool splits_by_sender_;
  std::vector<std::unique_ptr<VmcPerformer>> performers_;
};

}  // namespace

Result<std::unique_ptr<StreamDecoder>> make_vmc_decoder(const StreamUri& uri) {
  const std::string split = uri.option("split", "sender");
  if (split != "sender" && split != "port")
    return Error{"the option \"split\" is " + in_quotes(split) +
                     "; expected sender (every address is a performer) or port (all that comes is one)",
                 uri.text};
  return std::unique_ptr<StreamDecoder>(std::make_unique<VmcDecoder>(split == "sender"));
}

}  // namespace abrazo
