#pragma once

#include <functional>
#include <memory>
#include <string>

#include "core/session/run/recorder.hpp"
#include "core/stream/receive/stream_receiver.hpp"
#include "core/stream/send/pose_sink.hpp"

namespace abrazo {

/// Factories for the resources that a SessionEngine opens outside the program. Tests replace them.
struct SessionOpeners {
  std::function<Result<std::shared_ptr<StreamReceiver>>(const StreamUri&, const SessionClock&,
                                                        const StreamReceiverOptions&)>
      receiver;
  std::function<Result<std::unique_ptr<PoseSink>>(const StreamUri&, const Body&,
                                                  const std::string& character)>
      sink;
  std::function<Result<std::shared_ptr<Recorder>>(const std::string& path, const RecordingFacts&)> recorder;

  /// Sockets and session files.
  static SessionOpeners system();
};

}  // namespace abrazo
