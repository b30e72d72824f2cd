#pragma once

#include <memory>
#include <span>

#include "core/session/frames/decisions.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/synthesis/partner_synthesizer.hpp"

namespace abrazo {

/// Solves recorded inputs again, with the recorded settings or with others, on a synthesizer of its own: the
/// one that recorded them is never touched. With the recorded settings the results have the same bits.
/// Not thread-safe.
class ReSolver {
 public:
  /// Of the library and excluded takes that the frames were recorded with. Builds an index over the library.
  static Result<std::unique_ptr<ReSolver>> create(std::shared_ptr<const MotionLibrary> library,
                                                  const std::vector<std::string>& excluded_takes);
  explicit ReSolver(std::unique_ptr<PartnerSynthesizer> synthesizer);

  /// Goes to where the recording solver was before the frame after `run_up`, which starts with one that has a
  /// state. An empty run-up goes to before `next`, which then has a state itself.
  /// @throws std::invalid_argument when neither has one
  void go_to(std::span<const FrameSnapshotPtr> run_up, const FrameSnapshot& next);

  /// The input of `recorded` once more, after the frames solved so far: with its time and index, but these
  /// settings and their result. Decisions and fresh starts are those of the recording.
  std::shared_ptr<FrameSnapshot> solve(const FrameSnapshot& recorded, const Settings& settings);

 private:
  void follow_commands(const FrameSnapshot& recorded);
  void follow_decisions(const Decisions& decisions);

  std::unique_ptr<PartnerSynthesizer> synthesizer_;
  Decisions decisions_;  ///< those that the synthesizer was given
};

}  // namespace abrazo
