#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo {

/// A take of a library as frames of a session: looked at with everything that looks at solved frames. Nothing
/// is solved: the result of each frame is what was recorded, performer A where the active character is and B
/// where the passive one is, whoever leads; that is said by the take's roles. Frame f of the take has the
/// time f / fps and the index of its place among the library's frames of the take. Made when they are asked
/// for; those asked for last are kept.
class TakeFrames : public FrameStore {
 public:
  /// @return an Error when the library has no frame of such a take
  static Result<std::shared_ptr<const TakeFrames>> create(std::shared_ptr<const MotionLibrary> library,
                                                          std::string_view take);

  /// Of the take's file.
  virtual double fps() const = 0;
  /// Frames that the take's file has; the last ones may be missing in the library.
  virtual int take_frames() const = 0;
  /// The pair of the library that a frame is made of. @throws std::out_of_range
  virtual int pair(std::uint64_t index) const = 0;
};

/// Per edge of a mesh the mean of w_jl and w_lj, as Laplacian::build makes them with EdgeWeights::Inverse.
std::vector<double> inverse_edge_weights(std::span<const MeshEdge> edges, const PairPose& reference);

}  // namespace abrazo
