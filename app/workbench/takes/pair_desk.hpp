#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "core/annotation/annotations.hpp"
#include "core/library/takes/paired_take.hpp"
#include "core/session/run/pair_capture.hpp"

namespace abrazo {
class StreamReceiver;
}

namespace abrazo::app {

class Job;
class MainWindow;
class PairDialog;
class TakeDesk;

/// What other rooms know of a pair that is recorded.
struct PairSources {
  /// Of the connected stream, who plays the user and who dances with him; empty where nobody was chosen.
  std::function<std::pair<QString, QString>()> performers;
  /// What was said of the session.
  std::function<Annotations()> said;
};

/// Two streamed performers recorded as a take of the open library, which goes on without a restart.
class PairDesk : public QObject {
  Q_OBJECT
 public:
  PairDesk(MainWindow& window, TakeDesk& takes, PairSources sources);
  ~PairDesk() override;

  /// Begins, or ends and asks what the take is to be.
  void toggle();
  /// Adds a take to the library of the running session, on a worker. Errors are reported.
  void extend(const PairedTake& take);
  /// @param file  HDF5
  void save(const QString& file);

 signals:
  /// The library of the session has a take more.
  void extended(const QString& take);

 private:
  void begin();
  void listen();
  void stopListening();
  void ask();
  void add(PairDialog& dialog);

  MainWindow& m_window;
  TakeDesk& m_takes;
  PairSources m_sources;
  std::shared_ptr<PairCapture> m_capture;
  std::weak_ptr<StreamReceiver> m_receiver;
  std::optional<int> m_listener;
  QPointer<PairDialog> m_dialog;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
