#pragma once

#include <array>
#include <bitset>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/stream/humanoid/limb_ends.hpp"
#include "core/stream/protocol/stream_decoder.hpp"
#include "core/stream/xsens/xsens_packet.hpp"

namespace abrazo {

/// Conventions that the protocol does not transmit, if set by the user; others are detected from the data.
struct XsensConventions {
  std::optional<double> metres_per_unit;
  std::optional<char> up;  ///< 'y' or 'z', of types 02
};

/// Converts a counter with steps (a stream thinned by the sender) to one with step 1, so that a gap means a
/// loss.
class SampleSteps {
 public:
  std::int64_t number_of(std::uint32_t sample);

 private:
  std::optional<std::uint32_t> last_;
  std::int64_t number_ = 0;
  std::int64_t step_ = 0;  ///< smallest seen; 0 = none yet
};

/// One character of a stream: assembles samples from several datagrams and computes world positions of the
/// segments.
class XsensCharacter {
 public:
  XsensCharacter(int id, const XsensConventions& given) : id_(id), given_(given), up_(given.up) {}

  void take_meta(const XsensMeta& meta);
  void take_scale(const XsensScale& scale);
  /// A pose datagram (01, 02, 05).
  void take_pose(const XsensHeader& header, const std::vector<XsensSegment>& segments, double arrived_s,
                 Decoded& out);

  std::string fact() const;

 private:
  /// A sample with missing datagrams.
  struct Partial {
    XsensHeader header;
    double first_arrived_s = 0;
    std::array<XsensSegment, xsens_segment_count> segments;
    std::bitset<xsens_segment_count> have;
  };
  using Poses = std::array<SegmentPose, xsens_segment_count>;

  bool is_chosen(const XsensHeader& header, double arrived_s, Decoded& out);
  void complete(const Partial& sample, double arrived_s, Decoded& out);
  void place_relative(Poses& poses, std::vector<StreamIssue>& issues) const;
  std::optional<char> up_of_spine(const Poses& poses) const;
  void find_unit(const Poses& poses, std::vector<StreamIssue>& issues);
  Vec3 end_of(const Poses& poses, std::size_t end) const;

  int id_;
  XsensConventions given_;
  std::string name_;       ///< from the newest meta data
  std::string performer_;  ///< fixed by the first frame
  std::optional<char> up_;
  double metres_per_unit_ = 0;  ///< 0 = unknown so far
  std::optional<int> type_;     ///< the type in use, if several arrive
  double type_s_ = 0;
  SampleSteps steps_;
  std::vector<Partial> partials_;
  std::optional<std::uint32_t> completed_sample_;
  int finger_segments_ = 0;
  std::array<std::optional<Vec3>, 5> end_offsets_;                     ///< by the scale, Y up [m]
  std::array<std::optional<Vec3>, xsens_segment_count> rest_origins_;  ///< by the scale, Y up [m]
  std::shared_ptr<const std::vector<std::string>> points_, points_without_ends_;
};

}  // namespace abrazo
