#include "core/stream/natnet/natnet_frame.hpp"

#include <utility>

namespace abrazo {

namespace {

constexpr std::uint16_t tracked_flag = 0x01;
constexpr std::uint16_t occluded_flag = 0x01;
constexpr std::uint16_t recording_flag = 0x01, models_changed_flag = 0x02;
constexpr std::size_t body_bytes = 38;             // number, 3 + 4 floats, error, flags
constexpr std::size_t labelled_marker_bytes = 26;  // number, 3 floats, size, flags, residual
constexpr std::size_t channel_list_bytes = 8;      // number, number of channels

/// `number` elements, or fewer when the reader fails.
template <typename Read>
auto read_elements(ByteReader& reader, std::size_t number, const Read& read) {
  std::vector<decltype(read(reader))> elements;
  for (std::size_t i = 0; i < number && !reader.failed(); ++i) elements.push_back(read(reader));
  return elements;
}

/// Elements of a section, which since 4.1 states its size in bytes: bytes after its elements are skipped, so
/// that sections may grow. A size that contradicts the elements is an error.
/// @param unread receives the reason for skipping the section; null if the frame is useless without it
template <typename Read>
auto read_section(ByteReader& frame, NatNetVersion version, std::string_view what, std::size_t least_bytes,
                  const Read& read, std::vector<std::string>* unread = nullptr) {
  if (version < natnet_with_section_sizes) return read_elements(frame, frame.count(what, least_bytes), read);
  const std::size_t number = frame.count(what, 1);
  const std::int32_t bytes = frame.i32(what);
  ByteReader without_size = frame;
  const bool fits = bytes >= 0 && static_cast<std::size_t>(bytes) <= frame.left();
  ByteReader inner = frame.part(fits ? static_cast<std::size_t>(bytes) : 0, what);
  if (number > inner.left() / least_bytes)
    inner.fail(std::to_string(number) + " " + std::string(what) + " do not fit into the section's " +
               std::to_string(bytes) + " bytes");
  auto elements = read_elements(inner, number, read);
  if (!inner.failed()) return elements;
  elements = read_elements(without_size, number, read);
  if (!without_size.failed() || !fits || !unread) {
    frame = without_size;
  } else {
    unread->push_back(inner.failure());
    elements.clear();
  }
  return elements;
}

NatNetBody read_body(ByteReader& reader) {
  NatNetBody body;
  body.id = reader.i32("a rigid body's number");
  body.position = reader.vec3("a rigid body's position");
  const Vec3 xyz = reader.vec3("a rigid body's rotation");
  const auto w = static_cast<double>(reader.f32("a rigid body's rotation"));
  body.rotation = Eigen::Quaterniond(w, xyz.x(), xyz.y(), xyz.z());
  body.error_m = reader.f32("a rigid body's marker error");
  body.tracked = (reader.u16("a rigid body's flags") & tracked_flag) != 0;
  return body;
}

NatNetSkeletonFrame read_skeleton(ByteReader& reader) {
  NatNetSkeletonFrame skeleton;
  skeleton.id = reader.i32("a skeleton's number");
  skeleton.bones = read_elements(reader, reader.count("bones", body_bytes), read_body);
  return skeleton;
}

/// A named set of marker positions. @return its number of markers
std::size_t read_marker_set(ByteReader& reader) {
  reader.c_string("a marker set's name");
  const std::size_t markers = reader.count("markers of a set", 12);
  reader.skip(12 * markers, "markers of a set");
  return markers;
}

/// @return whether the marker is occluded
bool read_labelled_marker(ByteReader& reader) {
  reader.skip(4 + 12 + 4, "a labelled marker");
  const bool occluded = (reader.u16("a labelled marker's flags") & occluded_flag) != 0;
  reader.f32("a labelled marker's residual");
  return occluded;
}

/// Bones and markers of an asset of Motive 3.1. @return its number of markers
std::size_t read_asset(ByteReader& reader) {
  reader.i32("an asset's number");
  reader.skip(body_bytes * reader.count("rigid bodies of an asset", body_bytes), "an asset's rigid bodies");
  const std::size_t markers = reader.count("markers of an asset", labelled_marker_bytes);
  reader.skip(labelled_marker_bytes * markers, "an asset's markers");
  return markers;
}

/// A force plate or another device: samples per channel. @return its number of channels
std::size_t read_channels(ByteReader& reader) {
  reader.i32("a device's number");
  const std::size_t channels = reader.count("channels of a device", 4);
  for (std::size_t c = 0; c < channels && !reader.failed(); ++c)
    reader.skip(4 * reader.count("samples of a channel", 4), "samples of a channel");
  return channels;
}

void read_suffix(ByteReader& reader, NatNetVersion version, NatNetFrame& frame) {
  reader.skip(8, "the time code");
  const double time_s = reader.f64("the time stamp");
  if (reader.failed()) return;
  frame.time_s = time_s;
  NatNetStamps stamps;
  stamps.mid_exposure = reader.u64("the exposure's time stamp");
  stamps.received = reader.u64("the time stamp of receiving");
  stamps.transmit = reader.u64("the time stamp of sending");
  if (reader.failed()) return;
  frame.stamps = stamps;
  // Seconds and fraction of a precision clock precede the flags since 4.1, though some programs that say
  // 4.1 leave them out; the end tag tells.
  constexpr std::size_t precision_bytes = 8, flags_bytes = 2;
  if (version >= natnet_with_section_sizes && reader.left() >= precision_bytes + flags_bytes)
    reader.skip(precision_bytes, "the precision time stamp");
  const std::uint16_t flags = reader.u16("the frame's flags");
  if (reader.failed()) return;
  frame.recording = (flags & recording_flag) != 0;
  frame.models_changed = (flags & models_changed_flag) != 0;
}

/// The number of elements, from 4.1 on the size of the section, and the elements.
template <typename Elements, typename Write>
void write_section(ByteWriter& writer, NatNetVersion version, const Elements& elements, const Write& write) {
  writer.i32(static_cast<std::int32_t>(elements.size()));
  const std::size_t size_at = writer.size();
  const bool has_size = version >= natnet_with_section_sizes;
  if (has_size) writer.u32(0);
  const std::size_t from = writer.size();
  for (const auto& element : elements) write(element);
  if (has_size) writer.u32_at(size_at, static_cast<std::uint32_t>(writer.size() - from));
}

void write_nothing(ByteWriter& writer, NatNetVersion version) {
  write_section(writer, version, std::vector<int>(), [](int) {});
}

void write_body(ByteWriter& writer, const NatNetBody& body) {
  writer.i32(body.id);
  writer.vec3(body.position);
  const Eigen::Quaterniond& q = body.rotation;
  for (const double component : {q.x(), q.y(), q.z(), q.w()}) writer.f32(component);
  writer.f32(static_cast<double>(body.error_m));
  writer.u16(body.tracked ? tracked_flag : 0);
}

}  // namespace

Result<NatNetFrame> parse_natnet_frame(ByteReader& reader, NatNetVersion version) {
  NatNetFrame frame;
  frame.number = reader.i32("the frame's number");
  frame.marker_sets = read_section(reader, version, "marker sets", 5, read_marker_set).size();
  const auto read_position = [](ByteReader& from) { return from.vec3("an unlabelled marker"); };
  frame.unlabelled_markers = read_section(reader, version, "unlabelled markers", 12, read_position).size();
  frame.bodies = read_section(reader, version, "rigid bodies", body_bytes, read_body);
  frame.skeletons = read_section(reader, version, "skeletons", 8, read_skeleton);
  if (reader.failed()) return Error{reader.failure(), "frame"};

  std::vector<std::string>* unread = &frame.unread;
  if (version >= natnet_with_section_sizes)
    frame.assets = read_section(reader, version, "assets", 12, read_asset, unread).size();
  const auto labelled =
      read_section(reader, version, "labelled markers", labelled_marker_bytes, read_labelled_marker, unread);
  frame.labelled_markers = labelled.size();
  for (const bool occluded : labelled) frame.occluded_markers += occluded;
  frame.force_plates =
      read_section(reader, version, "force plates", channel_list_bytes, read_channels, unread).size();
  frame.devices = read_section(reader, version, "devices", channel_list_bytes, read_channels, unread).size();
  if (reader.failed()) {
    frame.unread.push_back(reader.failure());
    return frame;
  }
  read_suffix(reader, version, frame);
  return frame;
}

void write_natnet_frame(ByteWriter& writer, const NatNetFrame& frame, NatNetVersion version) {
  writer.i32(frame.number);
  write_nothing(writer, version);  // marker sets
  write_nothing(writer, version);  // unlabelled markers
  write_section(writer, version, frame.bodies, [&](const NatNetBody& body) { write_body(writer, body); });
  write_section(writer, version, frame.skeletons, [&](const NatNetSkeletonFrame& skeleton) {
    writer.i32(skeleton.id);
    writer.i32(static_cast<std::int32_t>(skeleton.bones.size()));
    for (const NatNetBody& bone : skeleton.bones) write_body(writer, bone);
  });
  if (version >= natnet_with_section_sizes) write_nothing(writer, version);      // assets
  for (int section = 0; section < 3; ++section) write_nothing(writer, version);  // markers, plates, devices
  writer.zeros(8);                                                               // time code
  writer.f64(frame.time_s.value_or(0));
  const NatNetStamps stamps = frame.stamps.value_or(NatNetStamps{});
  for (const std::uint64_t ticks : {stamps.mid_exposure, stamps.received, stamps.transmit}) writer.u64(ticks);
  if (version >= natnet_with_section_sizes) writer.zeros(8);  // precision time
  writer.u16(static_cast<std::uint16_t>((frame.recording ? recording_flag : 0) |
                                        (frame.models_changed ? models_changed_flag : 0)));
  writer.u32(0);  // end tag
}

}  // namespace abrazo
