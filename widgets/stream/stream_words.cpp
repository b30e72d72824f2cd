#include "widgets/stream/stream_words.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include "core/stream/protocol/stream_uri.hpp"

namespace abrazo::widgets {
namespace {

std::string fixed(double value, int decimals) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.*f", decimals, value);
  return text.data();
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::string percentiles(double p50_ms, double p95_ms) {
  return fixed(p50_ms, 1) + " / " + fixed(p95_ms, 1) + " ms";
}

StreamFigure counted(const char* name, std::uint64_t count, const char* help) {
  return {name, count_text(count), count > 0, help};
}

/// Of "192.168.1.20:50021", without the port.
std::string machine_words(const std::string& place) {
  const std::string address = place.substr(0, place.rfind(':'));
  return address.starts_with("127.") || address == "localhost" ? "this machine" : address;
}

/// The machines that send, or the one that is this performer.
std::string senders_words(const StreamHealth& health, const std::string& performer) {
  std::set<std::string> machines;
  for (const std::string& sender : health.senders) {
    if (sender == performer) return machine_words(sender);
    machines.insert(machine_words(sender));
  }
  return machines.size() > 1    ? std::to_string(machines.size()) + " machines"
         : machines.size() == 1 ? *machines.begin()
                                : "";
}

bool any_tracked(const StreamHealth& health) {
  return std::any_of(health.performers.begin(), health.performers.end(),
                     [](const PerformerHealth& performer) { return performer.tracked; });
}

}  // namespace

std::string stream_name(const StreamHealth& health, const std::string& performer) {
  const auto uri = parse_stream_uri(health.uri);
  if (!uri) return health.uri;
  const SchemeFacts& facts = facts_of(uri->scheme);
  std::string name(facts.title);
  // In VMC nobody has a name: its performers are addresses.
  if (!performer.empty() && uri->scheme != StreamUri::Scheme::Vmc) name = performer + ", " + name;
  if (facts.asks_server && uri->host != "0.0.0.0") return name + " at " + machine_words(uri->host);
  const std::string senders = senders_words(health, performer);
  return senders.empty() ? name : name + " from " + senders;
}

StreamHeadline headline_of(const StreamHealth* health) {
  if (!health) return {StreamMark::Off, "not connected", "No stream plays the user"};
  const std::string detail = health->listening.empty()
                                 ? health->uri
                                 : stream_name(*health) + ", " + listening_words(health->listening);
  switch (health->state) {
    case StreamHealth::State::Waiting:
      return {StreamMark::Waiting, "waiting for the first packet", detail};
    case StreamHealth::State::Stalled:
      return {StreamMark::Warning, "stalled: nothing comes in", detail};
    case StreamHealth::State::Failed:
      return {StreamMark::Bad, "failed", detail};
    case StreamHealth::State::Receiving:
      break;
  }
  if (!health->performers.empty() && !any_tracked(*health))
    return {StreamMark::Warning, "receiving, tracking lost", detail};
  const bool is_odd = std::any_of(
      health->diagnoses.begin(), health->diagnoses.end(),
      [](const StreamDiagnosis& one) { return one.severity == StreamDiagnosis::Severity::Error; });
  return is_odd ? StreamHeadline{StreamMark::Warning, "receiving, see the diagnosis", detail}
                : StreamHeadline{StreamMark::Good, "receiving", detail};
}

std::vector<StreamFigure> figures_of(const PerformerHealth& performer) {
  return {
      {"rate", fixed(performer.rate_hz, 1) + " Hz", false, "Poses per second"},
      {"delay", fixed(performer.delay_ms, 0) + " ms", false, "Delay added by the jitter buffer"},
      {"interval", percentiles(performer.interval_p50_ms, performer.interval_p95_ms), false,
       "Between two arrivals: median and 95th percentile of the last second or so"},
      {"assembly", percentiles(performer.assembly_p50_ms, performer.assembly_p95_ms), false,
       "From the first packet of a pose to its last: median and 95th percentile"},
      counted("lost", performer.lost, "Gaps in the sender's counter. VMC has no counter"),
      counted("late", performer.late, "Arrived after a newer pose was delivered; a longer delay helps"),
      counted("repeated", performer.repeated, "Received twice"),
      {"reordered", count_text(performer.reordered), false,
       "Arrived out of order, but in time for the jitter buffer"},
      counted("held joints", performer.held_joints,
              "Joints kept from the previous pose because they were not tracked"),
      counted("unusable", performer.unusable,
              "Frames that gave no pose: too many joints were not tracked, or unknown"),
      counted("interrupted", performer.interruptions, "Times that tracking was lost and came back"),
      counted("restarts", performer.restarts, "The sender restarted: its counter or its time began again"),
      {"clock", performer.uses_sender_time ? "sender's" : "arrival", false,
       "Whose times the poses have: the sender's, or those of their arrival if it sends none or they prove "
       "wrong"},
      counted("clock jumps", performer.clock_jumps, "Of the sender's clock"),
      {"replaced", count_text(performer.dropped), false,
       "Poses replaced by a newer one before the solver took them"}};
}

std::string body_line(const PerformerHealth& performer) {
  std::string line = performer.joint_map.empty() ? "no joint map fits" : performer.joint_map + " map";
  if (performer.height_m > 0) line += " · head at " + fixed(performer.height_m, 2) + " m";
  line += !performer.calibrated                  ? " · not calibrated"
          : performer.calibration_doubts.empty() ? " · calibrated"
                                                 : " · calibrated, doubtful";
  return performer.correction.empty() ? line : line + " · " + performer.correction;
}

std::string estimated_line(const PerformerHealth& performer) {
  return performer.estimated_joints.empty() ? "" : "estimated: " + joined(performer.estimated_joints);
}

std::vector<StreamFigure> traffic_of(const StreamHealth& health) {
  return {{"packets", count_text(health.packets), false, "Since connecting"},
          {"bytes", byte_count_text(health.bytes), false, "Since connecting"},
          counted("with issues", health.packets_with_issues, "Faulty packets; see below"),
          counted("overflowed", health.overflowed,
                  "Dropped by the operating system because they were not read in time")};
}

std::string count_text(std::uint64_t count) {
  std::string text = std::to_string(count);
  for (auto place = static_cast<std::ptrdiff_t>(text.size()) - 3; place > 0; place -= 3)
    text.insert(static_cast<std::size_t>(place), "\u202f");
  return text;
}

std::string byte_count_text(std::uint64_t bytes) {
  if (bytes < 1000) return std::to_string(bytes) + " bytes";
  constexpr std::array<const char*, 4> units = {"kB", "MB", "GB", "TB"};
  double value = static_cast<double>(bytes) / 1000;
  std::size_t unit = 0;
  for (; value >= 999.95 && unit + 1 < units.size(); ++unit) value /= 1000;
  return fixed(value, 1) + " " + units[unit];
}

std::string dump_text(std::span<const std::uint8_t> bytes) {
  std::string numbers, letters;
  for (const std::uint8_t byte : bytes) {
    std::array<char, 4> hex{};
    std::snprintf(hex.data(), hex.size(), "%02x ", byte);
    numbers += hex.data();
    letters += byte >= 0x20 && byte < 0x7f ? static_cast<char>(byte) : '.';
  }
  return numbers + " " + letters;
}

bool has_unknown_packets(const StreamHealth& health) {
  return std::any_of(health.first_bytes.begin(), health.first_bytes.end(),
                     [](std::uint8_t byte) { return byte != 0; });
}

std::string report_of(const StreamHealth& health) {
  const StreamHeadline head = headline_of(&health);
  std::string text = health.uri + ", " + head.detail + ": " + head.word + "\n";
  const auto add = [&text](const std::string& name, const std::string& value) {
    if (!value.empty()) text += name + ": " + value + "\n";
  };
  add("senders", joined(health.senders));
  for (const std::string& fact : health.facts) add("sender says", fact);
  for (const StreamFigure& figure : traffic_of(health)) add(figure.name, figure.value);
  for (const PerformerHealth& performer : health.performers) {
    text += "\n" + performer.performer + (performer.tracked ? ": tracked\n" : ": not tracked\n");
    add("body", body_line(performer));
    if (!performer.estimated_joints.empty()) text += estimated_line(performer) + "\n";
    for (const StreamFigure& figure : figures_of(performer)) add(figure.name, figure.value);
  }
  if (!health.diagnoses.empty() || !health.issues.empty()) text += "\n";
  for (const StreamDiagnosis& one : health.diagnoses)
    text += std::string(severity_word(one.severity)) + " " + one.kind + ": " + one.text + "\n";
  for (const IssueCount& issue : health.issues)
    text += count_text(issue.count) + " x " + issue.kind + ": " + issue.latest + "\n";
  if (has_unknown_packets(health))
    add("first bytes of a packet that was not understood", dump_text(health.first_bytes));
  return text;
}

}  // namespace abrazo::widgets
