#include "core/stream/receive/stream_diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <string>
#include <string_view>

#include "core/base/text.hpp"
#include "core/stream/net/usual_ports.hpp"

namespace abrazo {

namespace {

using Severity = StreamDiagnosis::Severity;
using Scheme = StreamUri::Scheme;

constexpr double patience_s = 2;  ///< before silence or unreadable packets are reported
constexpr double stalled_s = 1;
constexpr double frozen_after_s = 1;
constexpr double remembered_s = 10;  ///< time for which a jump or restart is shown
constexpr double low_rate_hz = 25;
constexpr double shortest_m = 0.8, tallest_m = 2.6, usual_m = 1.7;
constexpr double lowest_floor_m = -0.08, highest_floor_m = 0.20;
constexpr std::uint64_t enough_frames = 20;
constexpr double slow_known_after_s = 3;  ///< since the first frame: three intervals of 1 Hz

std::string number(double value, int digits = 0) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  const double share =
      100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::uint64_t>(1, whole));
  return number(share, share < 10 ? 1 : 0) + " %";
}

bool is_share(std::uint64_t part, std::uint64_t whole, double least) {
  return part > 0 && static_cast<double>(part) > least * static_cast<double>(whole);
}

std::string sender_name(const StreamObservation& seen) {
  return std::string(facts_of(seen.uri.scheme).sender);
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// Collects advice about one stream.
class Advice {
 public:
  void add(Severity severity, const std::string& kind, const std::string& text) {
    list_.push_back({kind, severity, text});
  }
  std::vector<StreamDiagnosis> sorted() {
    std::stable_sort(list_.begin(), list_.end(),
                     [](const auto& a, const auto& b) { return a.severity > b.severity; });
    return std::move(list_);
  }

 private:
  std::vector<StreamDiagnosis> list_;
};

void look_for_lost_address(const StreamObservation& seen, Advice& advice) {
  const std::string lost = "this machine no longer has the address " + seen.lost_address;
  if (seen.uri.scheme == Scheme::NatNet)
    advice.add(Severity::Error, "address-gone",
               lost + ", which interface= names: name the one it has now, or leave interface= out");
  else
    advice.add(Severity::Error, "address-gone",
               lost + ", which is listened at: listen on the one it has now, or on 0.0.0.0:" +
                   std::to_string(seen.uri.port) +
                   " (every network). When it has the address again, receiving resumes");
}

void look_for_silence(const StreamObservation& seen, Advice& advice) {
  if (!seen.lost_address.empty()) return look_for_lost_address(seen, advice);
  const bool never = seen.last_packet_s < 0;
  const double silence_s = seen.now_s - (never ? seen.opened_s : seen.last_packet_s);
  if (!never) {
    if (silence_s > stalled_s)
      advice.add(
          Severity::Error, "stalled",
          "no packet for " + number(silence_s, 1) +
              " s: the sender stopped or the network is cut; start it again, nothing has to be done here");
    return;
  }
  if (silence_s < patience_s) return;
  const std::string since = "no packet for " + number(silence_s) + " s: ";
  const std::string port = std::to_string(seen.uri.port);
  const bool only_here = seen.uri.host == "localhost" || seen.uri.host.starts_with("127.");
  if (seen.uri.scheme == Scheme::NatNet && seen.uri.host != "0.0.0.0")
    advice.add(
        Severity::Error, "no-packets",
        since + seen.uri.host + " does not answer on port " + port +
            ". In Motive switch streaming on and choose the network interface instead of loopback; let UDP " +
            port + " and " + std::to_string(natnet_data_port) +
            " through both firewalls; where Wi-Fi blocks multicast choose unicast");
  else if (only_here)
    advice.add(Severity::Error, "no-packets",
               since +
                   "only packets of this machine are taken at 127.0.0.1 (IPv4). Have the sender send to "
                   "127.0.0.1:" +
                   port + " (localhost may mean ::1 there), or listen on 0.0.0.0:" + port +
                   " (every network) when it runs on another machine");
  else
    advice.add(Severity::Error, "no-packets",
               since + "have the sender send to the address of this machine, port " + port + "; let UDP " +
                   port + " through the firewall; sender and receiver have to be in the same network");
  if (seen.uri.options.contains("multicast"))
    advice.add(
        Severity::Warning, "multicast-silent",
        "nothing came through the multicast group " + seen.uri.option("multicast") +
            "; name this machine's address in the capture network (interface=ADDRESS), or use unicast");
}

std::string shown(const StreamObservation& seen) {
  std::string hex, text;
  for (std::size_t i = 0; i < std::min(seen.first_bytes_count, seen.first_bytes.size()); ++i) {
    char digits[4];
    std::snprintf(digits, sizeof digits, "%02x ", seen.first_bytes[i]);
    hex += digits;
    text +=
        seen.first_bytes[i] >= 32 && seen.first_bytes[i] < 127 ? static_cast<char>(seen.first_bytes[i]) : '.';
  }
  return hex + "\"" + text + "\"";
}

void look_for_other_protocol(const StreamObservation& seen, Advice& advice) {
  if (seen.recent_unknown == 0) return;
  const bool understood = seen.last_understood_s >= 0 && seen.now_s - seen.last_understood_s < patience_s;
  if (understood) {
    if (is_share(seen.recent_unknown, seen.recent_packets, 0.02))
      advice.add(Severity::Warning, "unreadable-packets",
                 percent(seen.recent_unknown, seen.recent_packets) +
                     " of the packets cannot be read. The newest: " + seen.unreadable);
    return;
  }
  std::string text = "packets come, but not as " + sender_name(seen) + ". They begin with " + shown(seen);
  const auto protocol = protocol_of(seen.first_bytes, seen.first_bytes_count, seen.unknown_size);
  if (protocol && !protocol->starts_with(sender_name(seen)))
    text += ", which looks like " + *protocol + "; choose that protocol here, or another port";
  else
    text += ": " + (seen.unreadable.empty() ? "choose the protocol that the sender speaks" : seen.unreadable);
  advice.add(Severity::Error, "other-protocol", text);
}

void look_for_bones(const StreamObservation& seen, Advice& advice) {
  const bool understood = seen.last_understood_s >= 0 && seen.now_s - seen.last_understood_s < stalled_s;
  const double frame_s = std::max(seen.last_frame_s, seen.opened_s);
  if (!understood || seen.now_s - frame_s < patience_s) return;
  const StreamIssue& newest = seen.latest_issue;
  if (newest.kind == "missing-bones" || newest.kind == "old-version")
    return advice.add(Severity::Error, "no-bones", newest.text);
  std::string text = sender_name(seen) + " packets come, but no bones";
  switch (seen.uri.scheme) {
    case Scheme::Vmc:
      text +=
          ": the sender has no model loaded or is not tracking (OK 0), or sends only expressions or devices. "
          "Load an avatar there, start tracking, and switch on sending of bones";
      break;
    case Scheme::NatNet:
      text += ": in Motive's streaming settings switch on Skeletons, and solve a skeleton";
      break;
    default:
      text += ": in MVN's network streamer tick Position + Orientation (quaternion)";
      break;
  }
  if (!newest.text.empty()) text += ". The newest problem: " + newest.text;
  advice.add(Severity::Error, "no-bones", text);
}

std::size_t count_machines(const StreamObservation& seen) {
  std::set<std::string_view> machines;
  for (const std::string_view sender : seen.recent_senders)
    machines.insert(sender.substr(0, sender.rfind(':')));
  return machines.size();
}

/// Motive answers from one port and sends frames from another: of NatNet a machine is one sender.
std::size_t count_senders(const StreamObservation& seen) {
  return seen.uri.scheme == Scheme::NatNet ? count_machines(seen) : seen.recent_senders.size();
}

void look_for_two_senders(const StreamObservation& seen, Advice& advice) {
  if (count_senders(seen) < 2) return;
  constexpr std::size_t most_named = 4;
  const std::size_t count = seen.recent_senders.size();
  const bool are_more = count > most_named;
  const std::string who =
      std::to_string(count) + " senders send to this port (" +
      listed({seen.recent_senders.begin(),
              seen.recent_senders.begin() + static_cast<std::ptrdiff_t>(are_more ? most_named : count)}) +
      (are_more ? ", ...). " : "). ");
  if (seen.uri.scheme == Scheme::Vmc && are_more && count_machines(seen) == 1)
    return advice.add(Severity::Warning, "two-senders",
                      who +
                          "If it is one program that takes another port for every packet, receive with the "
                          "option split=port; each counts as a separate performer now");
  if (seen.uri.scheme == Scheme::Vmc)
    advice.add(Severity::Warning, "two-senders",
               who + "Each counts as a separate performer; choose who plays the user" +
                   (seen.followed.empty() ? "" : " (now " + seen.followed + ")") +
                   ". If one is left over from before, end it; two performers are safer on two ports" +
                   (count_machines(seen) == 1
                        ? ". If it is one program that takes another port for every packet, receive with "
                          "the option split=port"
                        : ""));
  else
    advice.add(Severity::Warning, "two-senders",
               who +
                   "Of two machines with the same performer name the first is accepted; two programs of one "
                   "machine " +
                   "mix: end one, or give it another port");
}

void look_at_who_is_heard(const StreamObservation& seen, Advice& advice) {
  if (!seen.undecided.empty())
    advice.add(Severity::Warning, "which-user",
               "who is the user? " + listed(seen.undecided) + " began to send within a second; " +
                   seen.followed +
                   " is followed now. Choose one, or name it in the address: performer=" + seen.followed);
  if (!seen.stranger.empty())
    advice.add(Severity::Warning, "stranger",
               seen.stranger + ". If the server answers from that address, connect to it instead");
  if (seen.last_sender_change_s >= 0 && seen.now_s - seen.last_sender_change_s < remembered_s)
    advice.add(Severity::Warning, "sender-changed", seen.sender_change);
}

void look_at_network(const StreamObservation& seen, Advice& advice) {
  if (seen.recent_overflow > 0)
    advice.add(
        Severity::Error, "kernel-overflow",
        std::to_string(seen.recent_overflow) +
            " packets were dropped by the system since this program did not take them in time; close what "
            "else keeps the computer busy, or allow a larger buffer (sysctl net.core.rmem_max=4194304)");
  if (!seen.group_failure.empty()) advice.add(Severity::Error, "multicast", seen.group_failure);
}

/// The advice about one performer.
class PerformerAdvice {
 public:
  PerformerAdvice(const StreamObservation& stream, const PerformerObservation& performer, Advice& advice)
      : stream_(stream), seen_(performer), health_(performer.health), advice_(advice) {}

  void look() {
    if (seen_.recent_frames == 0) return;  // silence is the stream's matter
    look_at_tracking();
    look_at_order();
    look_at_pace();
    look_at_clock();
    look_at_posture();
    look_at_calibration();
  }

 private:
  void add(Severity severity, const std::string& kind, const std::string& text) {
    advice_.add(severity, kind, (stream_.performers.size() > 1 ? health_.performer + ": " : "") + text);
  }

  void look_at_tracking() {
    if (!health_.tracked) {
      const bool ever = seen_.last_pose_s >= 0;
      const double since_s = stream_.now_s - (ever ? seen_.last_pose_s : seen_.first_s);
      if (ever || since_s > stream_.performer_loss_s)
        add(Severity::Error, ever ? "tracking-lost" : "no-pose",
            (ever ? "tracking is lost for " : "frames come without a pose for ") + number(since_s, 1) + " s" +
                (seen_.why_no_pose.empty() ? std::string() : ": " + seen_.why_no_pose));
    } else if (is_share(seen_.recent_held_frames, seen_.recent_frames, 0.05)) {
      add(Severity::Warning, "held-joints",
          "in " + percent(seen_.recent_held_frames, seen_.recent_frames) +
              " of the frames joints are not tracked and held from before; show their markers, or "
              "switch their bones on at the sender");
    }
  }

  void look_at_order() {
    const std::uint64_t expected = seen_.recent_frames + seen_.recent_lost;
    if (is_share(seen_.recent_lost, expected, 0.005))
      add(is_share(seen_.recent_lost, expected, 0.1) ? Severity::Error : Severity::Warning, "loss",
          percent(seen_.recent_lost, expected) +
              " of the frames are lost on the way; use a cable instead of Wi-Fi, or a lower rate");
    if (is_share(seen_.recent_late, seen_.recent_frames, 0.01))
      add(Severity::Warning, "late",
          percent(seen_.recent_late, seen_.recent_frames) +
              " of the frames come after a newer one and are left out; a delay of " +
              number(wise_delay_ms()) + " ms puts them in order");
    if (is_share(seen_.recent_repeated, seen_.recent_frames, 0.02))
      add(Severity::Warning, "repeated",
          percent(seen_.recent_repeated, seen_.recent_frames) +
              " of the frames come twice; let the sender send one way only (unicast or multicast, one "
              "network)");
    if (seen_.posture.alternating > 0.2)
      add(Severity::Error, "interleaved",
          "the pose jumps to and fro with each frame: two performers send under one name; give each a port "
          "of "
          "its own, or split them by sender");
    else if (seen_.posture.jumps > 0.1)
      add(Severity::Warning, "jumps",
          "the pose jumps farther than anybody moves in " + number(100 * seen_.posture.jumps) +
              " % of the frames; check the tracking, and whether two sources feed the sender");
  }

  double wise_delay_ms() const {
    const double spread =
        std::max(health_.interval_p95_ms - health_.interval_p50_ms, health_.interval_p50_ms);
    return std::min(500.0, 5 * std::ceil((health_.delay_ms + spread) / 5));
  }

  void look_at_pace() {
    if (seen_.frozen_s > frozen_after_s) {
      add(Severity::Warning, "frozen",
          "frames come but the pose has not changed for " + number(seen_.frozen_s, 1) +
              " s: the sender is paused, or its capture has stopped");
    } else {
      look_at_doubts();
    }
    if (health_.rate_hz <= 0) return;
    // A slow stream never has many frames; it is known by its intervals.
    const bool is_known =
        seen_.recent_frames >= enough_frames || stream_.now_s - seen_.first_s >= slow_known_after_s;
    if (is_known && health_.rate_hz < low_rate_hz)
      add(Severity::Warning, "low-rate",
          "only " + number(health_.rate_hz, 1) +
              " poses a second; the partner follows well from 60 on, raise the "
              "rate at the sender");
    if (seen_.recent_frames < enough_frames) return;
    const double spread_ms = health_.interval_p95_ms - health_.interval_p50_ms;
    if (spread_ms > std::max(8.0, health_.interval_p50_ms) && health_.delay_ms < spread_ms)
      add(Severity::Warning, "irregular",
          "poses come in bursts: one in twenty waits " + number(health_.interval_p95_ms) + " ms instead of " +
              number(health_.interval_p50_ms) + " ms; a delay of " + number(wise_delay_ms()) +
              " ms makes the motion even, a cable or another network interface the cause");
  }

  void look_at_doubts() {
    constexpr const char* instead = "; the times of arrival are used instead";
    switch (seen_.clock_doubt) {
      case SenderClock::Doubt::None:
        return;
      case SenderClock::Doubt::Stands:
        return add(Severity::Note, "frozen-clock",
                   std::string("the sender's time stands still while its poses move") + instead);
      case SenderClock::Doubt::Coarse:
        return add(Severity::Note, "coarse-clock",
                   std::string("the sender's time is a number too large to tell its frames apart, as of a "
                               "computer that runs for days, or since 1970") +
                       instead);
      case SenderClock::Doubt::Jumps:
        return add(
            Severity::Note, "unsteady-clock",
            std::string("the sender's time jumps again and again, so it does not count seconds") + instead);
    }
  }

  void look_at_clock() {
    const auto is_recent = [&](double time_s) {
      return time_s >= 0 && stream_.now_s - time_s < remembered_s;
    };
    if (is_recent(seen_.last_restart_s))
      add(Severity::Note, "sender-restarted",
          "the sender restarted " + number(stream_.now_s - seen_.last_restart_s, 1) +
              " s ago; it is followed from there, calibrate again if it was");
    if (is_recent(seen_.last_clock_jump_s))
      add(Severity::Note, "clock-jump",
          "the sender's clock jumped " + number(stream_.now_s - seen_.last_clock_jump_s, 1) +
              " s ago; it is followed from there. If it persists, set the sender's time synchronisation");
  }

  void look_at_posture() {
    const PostureMeter::Posture& posture = seen_.posture;
    if (!posture.is_known) return;
    const double height = posture.bones_height_m;
    if (!(height >= shortest_m && height <= tallest_m)) {
      add(Severity::Error, "unit", unit_text(height));
      return;  // what follows is in metres
    }
    if (posture.hips_above_feet_m < 0.15 * height) {
      const bool z_up = posture.hips_before_feet_m > 0.3 * height;
      add(Severity::Error, "axis",
          "the hips are " + number(posture.hips_above_feet_m, 2) + " m above the feet" +
              (z_up ? " but " + number(posture.hips_before_feet_m, 2) +
                          " m along Z: the sender's Z is up; add ?up=z, or choose Y up there"
                    : std::string(
                          ": lying, or the axes are turned; choose Y up at the sender, or calibrate")));
    } else if (posture.head_above_hips_m < 0.1 * height) {
      add(Severity::Warning, "rest-pose",
          "the head is not above the hips though the legs stand: the bones' rest rotations are not those "
          "expected; stand in the T-pose and calibrate");
    } else if (posture.lowest_foot_m < lowest_floor_m || posture.lowest_foot_m > highest_floor_m) {
      add(Severity::Warning, "floor",
          "the feet are at " + number(posture.lowest_foot_m, 2) +
              " m instead of the floor; calibrate, or add floor=METRES");
    }
  }

  std::string unit_text(double height) const {
    std::string text = "the body is " +
                       (height >= 10    ? number(height) + " m"
                        : height >= 0.1 ? number(height, 2) + " m"
                                        : number(100 * height, 1) + " cm") +
                       " tall";
    double best = 1, misfit = 1e9;
    for (const double factor : {1.0, 0.01, 0.001, 0.0254, 0.3048, 10.0, 100.0, 1000.0}) {
      const double off = std::abs(std::log(std::max(height, 1e-12) * factor / usual_m));
      if (off < misfit) best = factor, misfit = off;
    }
    if (best == 1 || misfit > 0.5) return text + "; check the scale of the avatar at the sender";
    if (stream_.uri.scheme == Scheme::Xsens) return text + "; add ?units=" + (best < 1 ? "cm" : "m");
    const std::string unit = best == 0.01 ? "cm" : best == 0.001 ? "mm" : exact_text(best);
    return text + ": the sender counts in " + (best < 1 ? "smaller" : "larger") +
           " units than metres; add ?unit=" + unit;
  }

  void look_at_calibration() {
    for (const std::string& doubt : health_.calibration_doubts)
      add(Severity::Warning, "calibration", "the T-pose is doubtful: " + doubt + ", then calibrate again");
    if (!health_.calibrated && !seen_.is_calibrating && health_.tracked && stream_.uri.scheme == Scheme::Vmc)
      add(Severity::Note, "not-calibrated",
          "the body is not measured yet; stand in the T-pose and calibrate");
  }

  const StreamObservation& stream_;
  const PerformerObservation& seen_;
  const PerformerHealth& health_;
  Advice& advice_;
};

}  // namespace

std::vector<StreamDiagnosis> diagnose(const StreamObservation& seen) {
  Advice advice;
  if (!seen.failure.empty()) {
    advice.add(Severity::Error, "failed", seen.failure + "; close the stream and open it again");
    return advice.sorted();
  }
  look_for_silence(seen, advice);
  look_for_other_protocol(seen, advice);
  look_for_bones(seen, advice);
  look_for_two_senders(seen, advice);
  look_at_who_is_heard(seen, advice);
  look_at_network(seen, advice);
  for (const PerformerObservation& performer : seen.performers)
    PerformerAdvice(seen, performer, advice).look();
  return advice.sorted();
}

}  // namespace abrazo
