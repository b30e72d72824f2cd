#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/motion/tables/c3d_parameters.hpp"

namespace abrazo {

/// Segments that a C3D file stores as 4x4 transforms (group ROTATION), as markerless programs do (Theia3D,
/// KinaTrax): 16 floats by columns, then one for the reliability; segments within samples within frames.
/// Source: C-Motion/HAS-Motion, "ROTATION data type" of the Visual3D documentation. The origin of a segment
/// is its proximal joint.
class C3dRotations {
 public:
  /// The rotations that the parameters announce; nothing where they announce none.
  /// @param point_rate frames of points per second, 0 if not known: to find the ratio if only a rate is given
  static Result<std::optional<C3dRotations>> announced(const C3dBytes& bytes, const C3dParameters& parameters,
                                                       double point_rate, std::string_view where);

  /// One per place that can be read: origins under the segments' names ("l_thigh_4X4"), then ends of the
  /// hands and toes and the head's centre, where Theia3D's own parameters state them ("l_hand_end").
  std::vector<std::string> names() const;
  std::size_t samples() const { return samples_; }      ///< complete ones in the file
  std::size_t announced() const { return announced_; }  ///< 0 if the file does not state it
  std::size_t ratio() const { return ratio_; }          ///< samples per frame of points
  double rate() const { return rate_; }                 ///< samples per second, 0 if not known
  std::size_t unnamed() const { return unnamed_; }      ///< segments without a label, which are left out

  /// All places of one sample, in the file's unit; NaN for a segment that was not seen.
  /// @return an Error if a segment's numbers are no transform: the last row is not 0 0 0 1, or the axes are
  /// not perpendicular and of length 1
  Result<Positions> places(std::size_t sample) const;

 private:
  struct Place {
    std::string name;
    std::size_t segment = 0;
    Vec3 local = Vec3::Zero();  ///< in the segment's axes, file unit
  };
  C3dRotations(const C3dBytes& bytes, std::string_view where) : bytes_(bytes), where_(where) {}
  void name_places(const C3dParameters& parameters);
  void add_end(const C3dParameters& parameters, const std::string& parameter, const std::string& segment,
               const std::string& name, const Vec3& direction);

  C3dBytes bytes_;
  std::string where_;
  std::size_t used_ = 0, data_ = 0, samples_ = 0, announced_ = 0, ratio_ = 1, unnamed_ = 0;
  double rate_ = 0;
  std::vector<Place> places_;
};

}  // namespace abrazo
