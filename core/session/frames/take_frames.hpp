#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "core/base/result.hpp"
#include "core/library/store/motion_library.hpp"
#include "core/session/frames/frame_store.hpp"

namespace abrazo {

/// A take of a library as session frames, so that every view of solved frames can show it. Nothing is solved:
/// the result of a frame is the recorded pair, with performer A as the active character and B as the passive
/// one, whoever leads; the take's roles say who leads. Frame f of the take has the time f / fps; its index is
/// its position among the library's frames of the take. Frames are made on demand and cached.
class TakeFrames : public FrameStore {
 public:
  /// @return an Error if the library has no frame of this take
  static Result<std::shared_ptr<const TakeFrames>> create(std::shared_ptr<const MotionLibrary> library,
                                                          std::string_view take);

  /// Of the take's file.
  virtual double fps() const = 0;
  /// Number of frames in the take's file; the last ones may be missing in the library.
  virtual int take_frames() const = 0;
  /// The library pair from which a frame is made. @throws std::out_of_range
  virtual int pair(std::uint64_t index) const = 0;
};

/// Per edge of a mesh the mean of w_jl and w_lj, as Laplacian::build makes them with EdgeWeights::Inverse.
std::vector<double> inverse_edge_weights(std::span<const MeshEdge> edges, const PairPose& reference);

}  // namespace abrazo
