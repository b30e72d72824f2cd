#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "core/selection/vetoes.hpp"
#include "core/session/frames/decisions.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

class FrameListener;
class PartnerSynthesizer;
class PoseSink;
class PoseSource;

/// Everything a view may request of the running solver. Applied in order, between two frames.
struct SetSettings {
  Settings settings;
};
struct PinPair {
  std::optional<int> pair;
};
/// Replaces all vetoes.
struct SetVetoes {
  Vetoes vetoes;
};
/// None cancels the intended move.
struct IntendMove {
  std::optional<IntendedMove> move;
};
struct SetRoleControl {
  RoleControl by = RoleControl::Hand;
};
struct ResetSolver {};
struct PauseInput {
  bool paused = true;
};  ///< pauses the clip that plays the user, now or again after a device
struct SeekInput {
  double time_s = 0;
};  ///< speed of the clip
struct SetInputSpeed {
  double factor = 1;
};

/// Replaces a part of a running session from the next frame on. The solver thread destroys the replaced one.
struct ReplaceSource {
  std::shared_ptr<PoseSource> source;
  std::shared_ptr<const std::string> input = nullptr;  ///< FrameSnapshot::input of its frames
};
/// Another library (a take was added). Settings and decisions stay, except decisions on pairs and takes that
/// are not in the new library.
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
