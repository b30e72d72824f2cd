#include "core/session/run/session_openers.hpp"

namespace abrazo {

SessionOpeners SessionOpeners::system() {
  SessionOpeners openers;
  openers.receiver = [](const StreamUri& uri, const SessionClock& clock,
                        const StreamReceiverOptions& options) {
    return StreamReceiver::open(uri, clock, options);
  };
  openers.sink = [](const StreamUri& uri, const Body& body, const std::string& character) {
    return PoseSink::open(uri, body, character);
  };
  openers.recorder = [](const std::string& path, const RecordingFacts& facts) {
    return Recorder::open(path, facts);
  };
  return openers;
}

}  // namespace abrazo
