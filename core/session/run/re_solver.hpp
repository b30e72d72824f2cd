#pragma once

#include <memory>
#include <optional>
#include <span>

#include "core/session/frames/decisions.hpp"
#include "core/session/frames/frame_snapshot.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"

namespace abrazo {

/// Solves recorded inputs again, with the recorded or other settings, on a separate synthesizer. With the
/// recorded settings the results are identical to the bit. Not thread-safe.
class ReSolver {
 public:
  /// Takes library and excluded takes of the recording. Builds an index over the library.
  static Result<std::unique_ptr<ReSolver>> create(std::shared_ptr<const MotionLibrary> library,
                                                  const std::vector<std::string>& excluded_takes);
  explicit ReSolver(std::unique_ptr<PartnerSynthesizer> synthesizer);

  /// Restores the recording solver's state before the frame after `run_up`, whose first frame has a state.
  /// With an empty run-up it restores the state in `next`.
  /// @throws std::invalid_argument if there is no state
  void go_to(std::span<const FrameSnapshotPtr> run_up, const FrameSnapshot& next);

  /// Solves the input of `recorded` after the frames solved so far. The frame has its time and index, and
  /// these settings and their result. Restarts are those of the recording.
  /// @param decisions none: those of the recording
  std::shared_ptr<FrameSnapshot> solve(const FrameSnapshot& recorded, const Settings& settings,
                                       const std::optional<Decisions>& decisions = std::nullopt);

 private:
  void follow_commands(const FrameSnapshot& recorded, const std::optional<Decisions>& instead = {});
  void follow_decisions(const Decisions& decisions);

  std::unique_ptr<PartnerSynthesizer> synthesizer_;
  Decisions decisions_;  ///< those last set in the synthesizer
};

}  // namespace abrazo
