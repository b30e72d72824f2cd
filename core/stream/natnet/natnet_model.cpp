#include "core/stream/natnet/natnet_model.hpp"

#include <algorithm>
#include <iterator>
#include <set>

namespace abrazo {

namespace {

enum class Description : std::int32_t { MarkerSet, RigidBody, Skeleton, ForcePlate, Device, Camera, Asset };

constexpr NatNetVersion marker_names_since{4, 0};
constexpr NatNetVersion rest_rotation_since{4, 2};
constexpr std::size_t bone_bytes = 1 + 4 + 4 + 12 + 4;  // name's zero, number, parent, offset, markers

NatNetBone read_bone(ByteReader& reader, NatNetVersion version) {
  NatNetBone bone;
  bone.name = reader.c_string("a rigid body's name");
  bone.id = reader.i32("a rigid body's number");
  bone.parent = reader.i32("a rigid body's parent");
  bone.offset = reader.vec3("a rigid body's offset");
  if (version >= rest_rotation_since) reader.skip(16, "a rigid body's rest rotation");
  const std::size_t markers = reader.count("markers of a rigid body", 12 + 4);
  reader.skip((12 + 4) * markers, "markers of a rigid body");  // positions, then active labels
  if (version >= marker_names_since)
    for (std::size_t m = 0; m < markers && !reader.failed(); ++m) reader.c_string("a marker's name");
  return bone;
}

/// "Ana_LUArm" of the skeleton "Ana" is "LUArm". Motive writes it so or so, by version.
std::string without_prefix(const std::string& bone, const std::string& skeleton) {
  for (const char separator : {'_', ':'})
    if (!skeleton.empty() && bone.size() > skeleton.size() + 1 && bone.starts_with(skeleton) &&
        bone[skeleton.size()] == separator)
      return bone.substr(skeleton.size() + 1);
  return bone;
}

/// Names that occur twice get their number, so that each means one bone.
void make_unique(std::vector<NatNetBone>& bones) {
  std::set<std::string> seen;
  for (NatNetBone& bone : bones)
    if (!seen.insert(bone.name).second) {
      bone.name += " (" + std::to_string(bone.id) + ")";
      seen.insert(bone.name);
    }
}

NatNetSkeleton read_skeleton(ByteReader& reader, NatNetVersion version) {
  NatNetSkeleton skeleton;
  skeleton.name = reader.c_string("a skeleton's name");
  skeleton.id = reader.i32("a skeleton's number");
  const std::size_t bones = reader.count("bones of a skeleton", bone_bytes);
  for (std::size_t b = 0; b < bones && !reader.failed(); ++b) {
    NatNetBone bone = read_bone(reader, version);
    bone.id &= 0xFFFF;
    bone.name = without_prefix(bone.name, skeleton.name);
    skeleton.bones.push_back(std::move(bone));
  }
  make_unique(skeleton.bones);
  return skeleton;
}

void skip_names(ByteReader& reader, std::string_view what) {
  const std::size_t names = reader.count(what, 1);
  for (std::size_t n = 0; n < names && !reader.failed(); ++n) reader.c_string(what);
}

void skip_force_plate(ByteReader& reader) {
  reader.i32("a force plate's number");
  reader.c_string("a force plate's serial number");
  constexpr std::size_t floats = 2 + 3 + 12 * 12 + 4 * 3;  // size, origin, calibration, corners
  reader.skip(4 * floats, "a force plate's measures");
  reader.skip(8, "a force plate's kind");
  skip_names(reader, "channels of a force plate");
}

void skip_device(ByteReader& reader) {
  reader.i32("a device's number");
  reader.c_string("a device's name");
  reader.c_string("a device's serial number");
  reader.skip(8, "a device's kind");
  skip_names(reader, "channels of a device");
}

void skip_asset(ByteReader& reader, NatNetVersion version) {
  reader.c_string("an asset's name");
  reader.skip(8, "an asset's kind and number");
  const std::size_t bodies = reader.count("rigid bodies of an asset", bone_bytes);
  for (std::size_t b = 0; b < bodies && !reader.failed(); ++b) read_bone(reader, version);
  const std::size_t markers = reader.count("markers of an asset", 1 + 4 + 12 + 4 + 2);
  for (std::size_t m = 0; m < markers && !reader.failed(); ++m) {
    reader.c_string("a marker's name");
    reader.skip(4 + 12 + 4 + 2, "a marker's description");
  }
}

/// @return whether the kind is known; otherwise nothing was read
bool read_description(ByteReader& reader, std::int32_t kind, NatNetVersion version, NatNetModel& model) {
  switch (static_cast<Description>(kind)) {
    case Description::MarkerSet:
      reader.c_string("a marker set's name");
      skip_names(reader, "markers of a set");
      ++model.marker_sets;
      return true;
    case Description::RigidBody:
      model.rigid_bodies.push_back(read_bone(reader, version).name);
      return true;
    case Description::Skeleton:
      model.skeletons.push_back(read_skeleton(reader, version));
      return true;
    case Description::ForcePlate:
      skip_force_plate(reader);
      ++model.force_plates;
      return true;
    case Description::Device:
      skip_device(reader);
      ++model.devices;
      return true;
    case Description::Camera:
      reader.c_string("a camera's name");
      reader.skip(12 + 16, "a camera's pose");
      ++model.cameras;
      return true;
    case Description::Asset:
      skip_asset(reader, version);
      ++model.assets;
      return true;
  }
  return false;
}

void append(NatNetModel& model, NatNetModel&& more) {
  std::move(more.skeletons.begin(), more.skeletons.end(), std::back_inserter(model.skeletons));
  std::move(more.rigid_bodies.begin(), more.rigid_bodies.end(), std::back_inserter(model.rigid_bodies));
  model.marker_sets += more.marker_sets;
  model.force_plates += more.force_plates;
  model.devices += more.devices;
  model.cameras += more.cameras;
  model.assets += more.assets;
}

/// A description with stated size: if unreadable, only this one is lost.
void read_sized(ByteReader& reader, std::int32_t kind, NatNetVersion version, NatNetModel& model) {
  const std::int32_t bytes = reader.i32("a description's size");
  if (bytes < 0) return reader.fail("a description claims " + std::to_string(bytes) + " bytes");
  ByteReader inner = reader.part(static_cast<std::size_t>(bytes), "a description");
  if (reader.failed()) return;
  NatNetModel read;
  if (!read_description(inner, kind, version, read))
    model.unread.push_back("a description of the unknown kind " + std::to_string(kind));
  else if (inner.failed())
    model.unread.push_back(inner.failure());
  else
    append(model, std::move(read));
}

void write_bone(ByteWriter& writer, const NatNetBone& bone, const std::string& name, NatNetVersion version) {
  writer.c_string(name);
  writer.i32(bone.id);
  writer.i32(bone.parent);
  writer.vec3(bone.offset);
  if (version >= rest_rotation_since)
    for (const double component : {0.0, 0.0, 0.0, 1.0}) writer.f32(component);
  writer.i32(0);  // markers
}

}  // namespace

Result<NatNetModel> parse_natnet_model(ByteReader& reader, NatNetVersion version) {
  NatNetModel model;
  const std::size_t descriptions = reader.count("descriptions", 4 + 4);
  for (std::size_t d = 0; d < descriptions && !reader.failed(); ++d) {
    const std::int32_t kind = reader.i32("a description's kind");
    if (version >= natnet_with_section_sizes) {
      read_sized(reader, kind, version, model);
    } else if (!read_description(reader, kind, version, model) && !reader.failed()) {
      // Without a size the start of the next one is unknown.
      model.unread.push_back("a description of the unknown kind " + std::to_string(kind) + " and " +
                             std::to_string(descriptions - d - 1) + " behind it");
      return model;
    }
  }
  if (reader.failed()) return Error{reader.failure(), "model description"};
  return model;
}

void write_natnet_model(ByteWriter& writer, const NatNetModel& model, NatNetVersion version) {
  writer.i32(static_cast<std::int32_t>(model.skeletons.size()));
  for (const NatNetSkeleton& skeleton : model.skeletons) {
    writer.i32(static_cast<std::int32_t>(Description::Skeleton));
    const std::size_t size_at = writer.size();
    if (version >= natnet_with_section_sizes) writer.u32(0);
    const std::size_t from = writer.size();
    writer.c_string(skeleton.name);
    writer.i32(skeleton.id);
    writer.i32(static_cast<std::int32_t>(skeleton.bones.size()));
    for (const NatNetBone& bone : skeleton.bones)
      write_bone(writer, bone, skeleton.name + "_" + bone.name, version);
    if (version >= natnet_with_section_sizes)
      writer.u32_at(size_at, static_cast<std::uint32_t>(writer.size() - from));
  }
}

}  // namespace abrazo
