#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>

#include "app/workbench/document/live_session.hpp"
#include "core/annotation/library_updates.hpp"

namespace abrazo::app {

class Job;
class MainWindow;

/// Puts what is said of takes into the library of the running session, on a worker: the newest counts. The
/// session goes on with it, and so do the views.
class LibraryFeed : public QObject {
  Q_OBJECT
 public:
  explicit LibraryFeed(MainWindow& window);
  ~LibraryFeed() override;

  /// What cannot be put in, an invalid role, is reported once.
  void put(const std::string& take, const Annotations& annotations);
  /// Nothing is waiting or under way.
  bool isIdle() const { return m_updates.is_idle(); }
  void forget();

 signals:
  /// The session goes on with another library.
  void fed();

 private:
  void begin();
  void show(PreparedSolver prepared);

  MainWindow& m_window;
  LibraryUpdates m_updates;
  std::unique_ptr<Job> m_job;
  QTimer m_soon;  ///< of several changes in a row the last
};

}  // namespace abrazo::app
