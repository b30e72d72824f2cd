#pragma once

#include <QObject>
#include <QPointer>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

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

/// Records two streamed performers as a take of the open library, without a restart of the session.
class PairDesk : public QObject {
  Q_OBJECT
 public:
  /// @param performers  the user and the second performer of the connected stream; empty = none
  PairDesk(MainWindow& window, TakeDesk& takes, std::function<std::pair<QString, QString>()> performers);
  ~PairDesk() override;

  /// Begins, or ends and asks for the properties of the take.
  void toggle();
  /// Adds a take to the library of the running session, on a worker. Errors are reported.
  void extend(const PairedTake& take);
  /// @param file  HDF5
  void save(const QString& file);

 signals:
  /// A take was added to the library of the session.
  void extended(const QString& take);

 private:
  void begin();
  void listen();
  void stopListening();
  void ask();
  void add(PairDialog& dialog);

  MainWindow& m_window;
  TakeDesk& m_takes;
  std::function<std::pair<QString, QString>()> m_performers;
  std::shared_ptr<PairCapture> m_capture;
  std::weak_ptr<StreamReceiver> m_receiver;
  std::optional<int> m_listener;
  QPointer<PairDialog> m_dialog;
  std::unique_ptr<Job> m_job;
};

}  // namespace abrazo::app
