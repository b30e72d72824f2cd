#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>

#include "app/workbench/document/document.hpp"
#include "core/annotation/library_updates.hpp"

namespace abrazo::app {

class Job;

/// Puts what is said of takes into the library of the running session, on a worker: the newest counts. The
/// document goes on with it.
class LibraryFeed : public QObject {
  Q_OBJECT
 public:
  explicit LibraryFeed(Document& document, QObject* parent = nullptr);
  ~LibraryFeed() override;

  /// What cannot be put in, an invalid role, is reported once by `failed`.
  void put(const std::string& take, const Annotations& annotations);
  /// Nothing is waiting or under way.
  bool isIdle() const { return m_updates.is_idle(); }
  /// What waits: it was said of the takes of a session or project that is gone.
  void forget();

 signals:
  void failed(const QString& why);

 private:
  void begin();

  Document& m_document;
  LibraryUpdates m_updates;
  std::unique_ptr<Job> m_job;
  QTimer m_soon;  ///< of several changes in a row the last
};

}  // namespace abrazo::app
