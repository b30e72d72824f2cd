#include "core/stream/xsens/xsens_packet.hpp"

#include <algorithm>

#include "core/base/text.hpp"

namespace abrazo {

namespace {

constexpr std::string_view magic = "MXTP";
constexpr std::uint8_t last_flag = 0x80;

/// By number - 1 of type 05: index into `xsens_segment_names`.
constexpr std::array<int, xsens_segment_count> unity_order = {0, 15, 16, 17, 18, 19, 20, 21, 22, 1, 2, 3,
                                                              4, 11, 12, 13, 14, 7,  8,  9,  10, 5, 6};

/// A length (i32) and that number of characters.
std::string read_string(ByteReader& reader, std::string_view what) {
  return reader.characters(reader.count(what, 1), what);
}

void write_string(ByteWriter& writer, std::string_view text) {
  writer.i32(static_cast<std::int32_t>(text.size()));
  writer.characters(text);
}

}  // namespace

Result<XsensHeader> parse_xsens_header(ByteReader& reader) {
  const std::string id = reader.characters(6, "\"MXTP\" and two digits");
  const bool is_digits = id.size() == 6 && id[4] >= '0' && id[4] <= '9' && id[5] >= '0' && id[5] <= '9';
  if (reader.failed()) return Error{reader.failure(), "truncated"};
  if (!id.starts_with(magic) || !is_digits)
    return Error{"no packet of Xsens MVN: those begin with \"MXTP\" and two digits", "other-protocol"};
  XsensHeader header;
  header.type = 10 * (id[4] - '0') + (id[5] - '0');
  header.sample = reader.u32("the sample counter");
  const std::uint8_t counter = reader.u8("the datagram counter");
  header.datagram = counter & static_cast<std::uint8_t>(~last_flag);
  header.is_last = (counter & last_flag) != 0;
  header.items = reader.u8("the number of items");
  header.time_ms = reader.u32("the time");
  header.character = reader.u8("the character's number");
  header.body_segments = reader.u8("the number of body segments");
  header.props = reader.u8("the number of props");
  header.finger_segments = reader.u8("the number of finger segments");
  reader.skip(2, "the reserved bytes");
  header.payload_bytes = reader.u16("the payload's size");
  if (reader.failed()) return Error{"header: " + reader.failure(), "truncated"};
  if (reader.left() < header.payload_bytes)
    return Error{"the header announces " + std::to_string(header.payload_bytes) + " bytes, but " +
                     std::to_string(reader.left()) + " follow",
                 "truncated"};
  // Before MVN 2019 these bytes were reserved.
  if (header.body_segments == 0) header.body_segments = xsens_segment_count;
  return header;
}

void write_xsens_header(ByteWriter& writer, const XsensHeader& header) {
  const auto byte = [](int number) { return static_cast<std::uint8_t>(number); };
  writer.characters(magic);
  writer.u8(byte('0' + header.type / 10 % 10));
  writer.u8(byte('0' + header.type % 10));
  writer.u32(header.sample);
  writer.u8(byte(header.datagram | (header.is_last ? last_flag : 0)));
  writer.u8(byte(header.items));
  writer.u32(header.time_ms);
  writer.u8(byte(header.character));
  writer.u8(byte(header.body_segments));
  writer.u8(byte(header.props));
  writer.u8(byte(header.finger_segments));
  writer.zeros(2);
  writer.u16(static_cast<std::uint16_t>(header.payload_bytes));
}

std::vector<XsensSegment> parse_xsens_segments(ByteReader& reader, const XsensHeader& header) {
  const bool is_euler = header.type == static_cast<int>(XsensType::PoseEuler);
  std::vector<XsensSegment> segments;
  for (int i = 0; i < header.items && !reader.failed(); ++i) {
    XsensSegment segment;
    segment.number = reader.i32("a segment's number");
    segment.position = reader.vec3("a segment's position");
    if (is_euler) {
      reader.skip(12, "a segment's angles");
    } else {
      const auto w = static_cast<double>(reader.f32("a segment's rotation"));
      const Vec3 xyz = reader.vec3("a segment's rotation");
      segment.rotation = Eigen::Quaterniond(w, xyz.x(), xyz.y(), xyz.z());
    }
    segments.push_back(segment);
  }
  return segments;
}

void write_xsens_segment(ByteWriter& writer, const XsensSegment& segment) {
  writer.i32(segment.number);
  writer.vec3(segment.position);
  const Eigen::Quaterniond q = segment.rotation.value_or(Eigen::Quaterniond::Identity());
  for (const double component : {q.w(), q.x(), q.y(), q.z()}) writer.f32(component);
}

std::optional<int> xsens_body_segment(int number, XsensType type) {
  if (number < 1 || number > xsens_segment_count) return std::nullopt;
  const int index = number - 1;
  return type == XsensType::PoseUnity ? unity_order[static_cast<std::size_t>(index)] : index;
}

XsensMeta parse_xsens_meta(ByteReader& reader) {
  XsensMeta meta;
  std::string text = reader.characters(reader.left(), "tags");
  if (text.size() >= 4) {
    std::size_t length = 0;
    for (int i = 0; i < 4; ++i)
      length = length << 8 | static_cast<std::uint8_t>(text[static_cast<std::size_t>(i)]);
    if (length <= text.size() - 4) text = text.substr(4, length);
  }
  for (const std::string_view line : split_lines(text)) {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos || lower_case(trimmed(line.substr(0, colon))) != "name") continue;
    for (const char c : trimmed(line.substr(colon + 1)))
      if (static_cast<unsigned char>(c) >= ' ') meta.name += c;
  }
  return meta;
}

void write_xsens_meta(ByteWriter& writer, const XsensMeta& meta) {
  write_string(writer, "name:" + meta.name + "\n");
}

XsensScale parse_xsens_scale(ByteReader& reader) {
  XsensScale scale;
  const std::size_t segments = reader.count("segments", 4 + 12);
  for (std::size_t s = 0; s < segments && !reader.failed(); ++s) {
    std::string name = read_string(reader, "characters of a segment's name");
    scale.segments.emplace_back(std::move(name), reader.vec3("a segment's origin"));
  }
  const std::size_t points = reader.count("points", 2 + 2 + 4 + 4 + 12);
  for (std::size_t p = 0; p < points && !reader.failed(); ++p) {
    XsensPoint point;
    point.segment = reader.u16("a point's segment");
    point.id = reader.u16("a point's number");
    point.name = read_string(reader, "characters of a point's name");
    reader.skip(4, "a point's flags");
    point.offset = reader.vec3("a point's place");
    scale.points.push_back(std::move(point));
  }
  return scale;
}

void write_xsens_scale(ByteWriter& writer, const XsensScale& scale) {
  writer.i32(static_cast<std::int32_t>(scale.segments.size()));
  for (const auto& [name, origin] : scale.segments) {
    write_string(writer, name);
    writer.vec3(origin);
  }
  writer.i32(static_cast<std::int32_t>(scale.points.size()));
  for (const XsensPoint& point : scale.points) {
    writer.u16(static_cast<std::uint16_t>(point.segment));
    writer.u16(static_cast<std::uint16_t>(point.id));
    write_string(writer, point.name);
    writer.u32(0);
    writer.vec3(point.offset);
  }
}

}  // namespace abrazo
