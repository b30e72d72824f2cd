#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.hpp"
#include "core/base/session_clock.hpp"
#include "core/session/frames/command.hpp"
#include "core/session/frames/frame_history.hpp"
#include "core/session/frames/latest_slot.hpp"
#include "core/session/run/history_keeper.hpp"
#include "core/session/run/live_loop.hpp"
#include "core/session/run/meant_choices.hpp"
#include "core/session/run/recorder.hpp"
#include "core/session/run/session_openers.hpp"
#include "core/stream/receive/stream_receiver.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"

namespace abrazo {

/// A running session with its solver thread, source, sinks and recorder; used by the window and by `abrazo
/// live`. Called by one thread (the window's). The destructor waits for the running step and the recorder's
/// queue. The library is prepared for both roles in the background, so that a role change does not delay the
/// solver.
class SessionEngine {
 public:
  /// @param recorded  frames of the session so far, which it continues: its own follow their indices. The
  /// clock must be later than these frames
  SessionEngine(std::unique_ptr<PartnerSynthesizer> synthesizer, std::shared_ptr<PoseSource> source,
                SessionClock clock = SessionClock(), SessionOpeners openers = SessionOpeners::system(),
                std::shared_ptr<const FrameStore> recorded = nullptr);
  ~SessionEngine();

  void push(const Command& command);
  /// Declares the intended move. An Error if it matches no selectable pair; it lists the available moves.
  Status intend(const IntendedMove& move);
  /// Sets the role control. An Error if the library lacks the annotations it needs.
  Status control_role(RoleControl by);
  /// The moves that can be intended now, nearest to the newest frame first.
  std::vector<MeantChoice> meant_choices() const;
  const FrameHistory& history() const;
  const LatestSlot<FrameSnapshot>& latest() const;
  const SessionClock& clock() const;
  /// How far the clip is solved that is solved over its length; none: the input is another.
  std::optional<LiveLoop::ClipProgress> clip_progress() const;
  /// The time of the frame that is seen: around it a change is solved first.
  void look_at(double clip_time_s);
  /// Whether the clip that plays the user is held: nothing is recorded until it continues.
  bool is_held() const;

  /// Opens a stream; from then on its poses are the user's. The previous source stays ready. No change on
  /// failure.
  /// @param performer empty = the first that appears
  Status receive(const StreamUri& uri, const std::string& performer = {},
                 const StreamReceiverOptions& options = {});
  /// Selects another performer of the open stream as the user.
  void follow_performer(const std::string& performer);
  /// Closes the stream and returns to the source of the constructor.
  void stop_receiving();
  std::shared_ptr<StreamReceiver> receiver() const;  ///< null if no stream is open

  /// Sends a character's poses to the URI, with the bone lengths of the library's performer in its role, also
  /// after role or library change.
  Status send(const StreamUri& uri, Character character);
  void stop_sending(const std::string& uri);
  std::vector<SinkHealth> sinks() const;

  /// Keeps of the solved frames only the newest in memory: for programs in which nobody looks back.
  void forget_history();
  /// Keeps the frames of this session on disk, also those that no longer fit in memory. Once in a session.
  void keep_history(std::shared_ptr<HistoryKeeper> keeper);
  std::shared_ptr<HistoryKeeper> history_keeper() const;  ///< null if history is in memory only

  /// Records everything from now on into a session file, which also extends the history.
  Status record(const std::string& path, const RecordingFacts& facts);
  std::shared_ptr<Recorder> recorder() const;  ///< null if not recording
  /// Stops recording and waits until the file is whole, which on a slow disk takes seconds.
  /// @return an Error if writing failed
  Status stop_recording();
  /// Stops recording without waiting. @return what has still to be finished; null if not recording
  std::shared_ptr<Recorder> release_recorder();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace abrazo
