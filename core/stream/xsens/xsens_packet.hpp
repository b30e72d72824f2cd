#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/stream/protocol/byte_reader.hpp"
#include "core/stream/protocol/byte_writer.hpp"

namespace abrazo {

/// The two digits behind "MXTP" (docs/guide/live/xsens.md). Other types exist and are ignored.
enum class XsensType : int {
  PoseEuler = 1,
  PoseQuaternion = 2,
  PosePoints = 3,
  PoseUnity = 5,
  Meta = 12,
  Scale = 13,
  TimeCode = 25
};

inline constexpr int xsens_segment_count = 23;

/// Body segments in the order of their numbers (from 1) in types 01 and 02.
inline constexpr std::array<std::string_view, xsens_segment_count> xsens_segment_names = {"Pelvis",
                                                                                          "L5",
                                                                                          "L3",
                                                                                          "T12",
                                                                                          "T8",
                                                                                          "Neck",
                                                                                          "Head",
                                                                                          "RightShoulder",
                                                                                          "RightUpperArm",
                                                                                          "RightForearm",
                                                                                          "RightHand",
                                                                                          "LeftShoulder",
                                                                                          "LeftUpperArm",
                                                                                          "LeftForearm",
                                                                                          "LeftHand",
                                                                                          "RightUpperLeg",
                                                                                          "RightLowerLeg",
                                                                                          "RightFoot",
                                                                                          "RightToe",
                                                                                          "LeftUpperLeg",
                                                                                          "LeftLowerLeg",
                                                                                          "LeftFoot",
                                                                                          "LeftToe"};

/// Index of the parent, -1 for the pelvis; parents come first.
inline constexpr std::array<int, xsens_segment_count> xsens_parents = {
    -1, 0, 1, 2, 3, 4, 5, 4, 7, 8, 9, 4, 11, 12, 13, 0, 15, 16, 17, 0, 19, 20, 21};

struct XsensHeader {
  int type = 0;
  std::uint32_t sample = 0;
  int datagram = 0;      ///< index in the sample, from 0
  bool is_last = false;  ///< of the sample
  int items = 0;
  std::uint32_t time_ms = 0;  ///< on the sender's clock, 0 at the start of a recording
  int character = 0;
  int body_segments = xsens_segment_count;  ///< in all datagrams of the sample
  int props = 0, finger_segments = 0;
  std::size_t payload_bytes = 0;  ///< 0 = not stated (older senders)
};
inline constexpr std::size_t xsens_header_bytes = 24;

/// @return an Error of kind "other-protocol" or "truncated" (in `where`)
Result<XsensHeader> parse_xsens_header(ByteReader& reader);
void write_xsens_header(ByteWriter& writer, const XsensHeader& header);

/// A segment as sent, with units, axes and parent of the type.
struct XsensSegment {
  int number = 0;  ///< from 1 on, in the order of its type
  Vec3 position = Vec3::Zero();
  std::optional<Eigen::Quaterniond> rotation;  ///< as sent: not checked; none for Euler angles
};

/// The items of a pose datagram (01, 02, 05). Look at `reader.failed()` afterwards.
std::vector<XsensSegment> parse_xsens_segments(ByteReader& reader, const XsensHeader& header);
/// One item of type 02.
void write_xsens_segment(ByteWriter& writer, const XsensSegment& segment);

/// Index into `xsens_segment_names` for a number in the order of a type; none for props and fingers.
std::optional<int> xsens_body_segment(int number, XsensType type);

/// The tags of a type 12: "name", "xmid", "color". Some senders put the text's length before it, some do not.
struct XsensMeta {
  std::string name;
};
XsensMeta parse_xsens_meta(ByteReader& reader);
void write_xsens_meta(ByteWriter& writer, const XsensMeta& meta);

/// A point of a segment in the rest pose, relative to the segment's origin, Z up.
struct XsensPoint {
  int segment = 0;  ///< number, from 1 on
  int id = 0;
  std::string name;
  Vec3 offset = Vec3::Zero();
};

/// A message of type 13; usually several complement each other.
struct XsensScale {
  std::vector<std::pair<std::string, Vec3>> segments;  ///< name, origin in the rest pose
  std::vector<XsensPoint> points;
};
/// Look at `reader.failed()` afterwards.
XsensScale parse_xsens_scale(ByteReader& reader);
void write_xsens_scale(ByteWriter& writer, const XsensScale& scale);

}  // namespace abrazo
