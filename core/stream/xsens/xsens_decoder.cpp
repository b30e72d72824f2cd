#include "core/stream/xsens/xsens_decoder.hpp"

#include <map>

#include "core/stream/protocol/sender_hold.hpp"
#include "core/stream/xsens/xsens_character.hpp"

namespace abrazo {

namespace {

Result<XsensConventions> parse_xsens_options(const StreamUri& uri) {
  XsensConventions conventions;
  if (const std::string units = uri.option("units"); !units.empty()) {
    if (units != "m" && units != "cm")
      return Error{"units=" + units + " is not known; expected m or cm", uri.text};
    conventions.metres_per_unit = units == "cm" ? 0.01 : 1.0;
  }
  if (const std::string up = uri.option("up"); !up.empty()) {
    if (up != "y" && up != "z") return Error{"up=" + up + " is not known; expected y or z", uri.text};
    conventions.up = up.front();
  }
  return conventions;
}

class XsensDecoder : public StreamDecoder {
 public:
  explicit XsensDecoder(const XsensConventions& conventions) : conventions_(conventions) {}

  void take(const Datagram& datagram, Decoded& out) override;
  void pass_time(double now_s, Decoded& out) override;
  void calibrate(const std::string& /*performer*/) override {}
  std::vector<std::string> facts() const override;

 private:
  bool is_from_its_sender(const XsensHeader& header, const Datagram& datagram, Decoded& out);
  void take_content(const XsensHeader& header, ByteReader& reader, const Datagram& datagram, Decoded& out);
  XsensCharacter& character(const XsensHeader& header) {
    return characters_.try_emplace(header.character, header.character, conventions_).first->second;
  }

  XsensConventions conventions_;
  std::map<int, XsensCharacter> characters_;
  std::map<int, SenderHold> senders_;       ///< of the characters
  std::map<int, std::size_t> other_types_;  ///< datagrams without a pose that can be used, by type
  std::string time_code_;
  std::optional<double> pose_s_, other_s_, told_s_;
};

void XsensDecoder::take(const Datagram& datagram, Decoded& out) {
  ByteReader reader(datagram.bytes, ByteOrder::Big);
  const Result<XsensHeader> header = parse_xsens_header(reader);
  if (!header) {
    out.issues.push_back({header.error().where, header.error().message});
    return;
  }
  ByteReader content =
      reader.part(header->payload_bytes > 0 ? header->payload_bytes : reader.left(), "the payload");
  if (!is_from_its_sender(*header, datagram, out)) return;
  take_content(*header, content, datagram, out);
  if (content.failed()) out.issues.push_back({"truncated", content.failure()});
}

/// A datagram identifies a character only by a number, which any machine can send: the number belongs to the
/// machine that sent its first pose. Poses, names and scales of other machines are ignored.
bool XsensDecoder::is_from_its_sender(const XsensHeader& header, const Datagram& datagram, Decoded& out) {
  SenderHold& sender = senders_[header.character];
  const std::optional<std::uint32_t> before = sender.address();
  const std::string name = "character " + std::to_string(header.character);
  switch (sender.claim(datagram.from, datagram.arrived_s)) {
    case SenderHold::Answer::Refused:
      out.issues.push_back({"other-sender", name + " of " + address_text(datagram.from.address) +
                                                " is left out: that of " + address_text(*before) +
                                                " came first. Give one of them another port"});
      return false;
    case SenderHold::Answer::NewHolder:
      characters_.erase(header.character);
      if (before)
        out.issues.push_back({"sender-changed", name + " comes from " + address_text(datagram.from.address) +
                                                    " now, since " + address_text(*before) +
                                                    " sent no pose of it for a while"});
      return true;
    case SenderHold::Answer::Holder:
      break;
  }
  return true;
}

void XsensDecoder::take_content(const XsensHeader& header, ByteReader& reader, const Datagram& datagram,
                                Decoded& out) {
  switch (static_cast<XsensType>(header.type)) {
    case XsensType::PoseEuler:
    case XsensType::PoseQuaternion:
    case XsensType::PoseUnity: {
      const std::vector<XsensSegment> segments = parse_xsens_segments(reader, header);
      if (reader.failed()) return;
      pose_s_ = datagram.arrived_s;
      senders_[header.character].sent_something_useful(datagram.arrived_s);
      character(header).take_pose(header, segments, datagram.arrived_s, out);
      return;
    }
    case XsensType::Meta:
      character(header).take_meta(parse_xsens_meta(reader));
      return;
    case XsensType::Scale: {
      const XsensScale scale = parse_xsens_scale(reader);
      if (!reader.failed()) character(header).take_scale(scale);
      return;
    }
    case XsensType::TimeCode: {
      constexpr std::size_t length = 12;  // HH:MM:SS.mmm, by some senders behind its length
      if (reader.left() >= length + 4) reader.skip(4, "the time code's length");
      time_code_.clear();
      for (const char c : reader.characters(length, "a time code"))
        time_code_ += c >= ' ' && c <= '~' ? c : '?';
      return;
    }
    default:
      ++other_types_[header.type];
      other_s_ = datagram.arrived_s;
  }
}

void XsensDecoder::pass_time(double now_s, Decoded& out) {
  constexpr double told_every_s = 5, silence_s = 2;
  const bool has_only_others =
      other_s_ && now_s - *other_s_ < silence_s && (!pose_s_ || now_s - *pose_s_ > silence_s);
  if (!has_only_others || (told_s_ && now_s - *told_s_ < told_every_s)) return;
  told_s_ = now_s;
  out.issues.push_back(
      {"no-poses",
       "MVN sends, but no positions of segments: tick Position + Orientation (Quaternion) in "
       "the network streamer"});
}

std::vector<std::string> XsensDecoder::facts() const {
  std::vector<std::string> facts;
  for (const auto& [id, character] : characters_) facts.push_back(character.fact());
  if (!time_code_.empty()) facts.push_back("time code " + time_code_);
  if (!other_types_.empty()) {
    std::string types;
    for (const auto& [type, count] : other_types_)
      types += (types.empty() ? "" : ", ") + std::string(type < 10 ? "0" : "") + std::to_string(type) + " (" +
               std::to_string(count) + ")";
    facts.push_back("datagrams of types that are not used: " + types);
  }
  return facts;
}

}  // namespace

Result<std::unique_ptr<StreamDecoder>> make_xsens_decoder(const StreamUri& uri) {
  const Result<XsensConventions> conventions = parse_xsens_options(uri);
  if (!conventions) return conventions.error();
  return std::unique_ptr<StreamDecoder>(std::make_unique<XsensDecoder>(*conventions));
}

}  // namespace abrazo
