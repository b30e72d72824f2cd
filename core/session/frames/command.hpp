#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "core/selection/vetoes.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

class FrameListener;
class PartnerSynthesizer;
class PoseSink;
class PoseSource;

/// All a view may ask of the running solver. Applied in order, between two frames.
struct SetSettings {
  Settings settings;
};
struct PinPair {
  std::optional<int> pair;
};
/// All of them, in place of those before.
struct SetVetoes {
  Vetoes vetoes;
};
/// Nothing takes it back.
struct IntendMove {
  std::optional<MeantMove> move;
};
struct SetRoleControl {
  RoleControl by = RoleControl::Hand;
};
struct ResetSolver {};
struct PauseInput {
  bool paused = true;
};  ///< the clip that stands in for the user holds still
struct SeekInput {
  double time_s = 0;
};  ///< of the clip
struct SetInputSpeed {
  double factor = 1;
};

/// The parts of a running session, from the next frame on. What is replaced is destroyed by the solver
/// thread.
struct ReplaceSource {
  std::shared_ptr<PoseSource> source;
  std::shared_ptr<const std::string> input = nullptr;  ///< FrameSnapshot::input of its frames
};
/// Another library (a take was added): settings and decisions stay, those on pairs and takes that the new one
/// does not have fall away.
struct ReplaceSynthesizer {
  std::shared_ptr<PartnerSynthesizer> synthesizer;
};
struct AttachListener {
  std::shared_ptr<FrameListener> listener;
};
struct DetachListener {
  std::shared_ptr<FrameListener> listener;
};
enum class Character { User, Partner };
struct AttachSink {
  Character character = Character::Partner;
  std::shared_ptr<PoseSink> sink;
};
struct DetachSink {
  std::shared_ptr<PoseSink> sink;
};

using Command = std::variant<SetSettings, PinPair, SetVetoes, IntendMove, SetRoleControl, ResetSolver,
                             PauseInput, SeekInput, SetInputSpeed, ReplaceSource, ReplaceSynthesizer,
                             AttachListener, DetachListener, AttachSink, DetachSink>;

}  // namespace abrazo
