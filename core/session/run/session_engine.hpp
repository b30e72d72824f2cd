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
#include "core/session/run/meant_choices.hpp"
#include "core/session/run/recorder.hpp"
#include "core/session/run/session_openers.hpp"
#include "core/stream/receive/stream_receiver.hpp"
#include "core/synthesis/partner_synthesizer.hpp"

namespace abrazo {

/// A running session with all that belongs to it: solver thread, source, sinks, recorder. One for the window
/// and for `abrazo live`. Called by one thread (the window's); ends with this object, which waits for the
/// running step and for what the recorder still has to write. The library is prepared for both roles beside
/// the solver, so that a change of the user's role does not hold it up.
class SessionEngine {
 public:
  SessionEngine(std::unique_ptr<PartnerSynthesizer> synthesizer, std::shared_ptr<PoseSource> source,
                SessionClock clock = SessionClock(), SessionOpeners openers = SessionOpeners::system());
  ~SessionEngine();

  void push(const Command& command);
  /// `push` of what cannot be taken back by looking at it: an Error when no pair that may be selected is
  /// meant; it lists what could be.
  Status intend(const MeantMove& move);
  /// An Error when the library does not say who leads, and only the hand can decide.
  Status control_role(RoleControl by);
  /// The moves that could be intended now, best fit to the newest frame first.
  std::vector<MeantChoice> meant_choices() const;
  const FrameHistory& history() const;
  const LatestSlot<FrameSnapshot>& latest() const;
  const SessionClock& clock() const;

  /// Opens a stream and takes its poses for the user's from then on; the source there was stays ready.
  /// @param performer  empty = the first that is seen
  /// On a failure all stays as it was.
  Status receive(const StreamUri& uri, const std::string& performer = {},
                 const StreamReceiverOptions& options = {});
  /// Another performer of the open stream plays the user.
  void follow_performer(const std::string& performer);
  /// Closes the stream; the source of the constructor goes on.
  void stop_receiving();
  std::shared_ptr<StreamReceiver> receiver() const;  ///< null when no stream is open

  /// A character's poses to where the URI says, with the bones of the library's performer in its role, also
  /// after that role or the library changed.
  Status send(const StreamUri& uri, Character character);
  void stop_sending(const std::string& uri);
  std::vector<SinkHealth> sinks() const;

  /// Goes on from a recorded session: its frames are the history so far. To be called before the first frame;
  /// the clock has to be behind them.
  void look_back(std::shared_ptr<const FrameStore> recorded);

  /// Everything from now on into a session file; the history reaches back into it.
  Status record(const std::string& path, const RecordingFacts& facts);
  std::shared_ptr<Recorder> recorder() const;  ///< null when nothing is recorded
  /// @return what went wrong while writing
  Status stop_recording();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace abrazo
