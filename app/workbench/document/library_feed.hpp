#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <string>

#include "app/workbench/document/document.hpp"
#include "core/annotation/library_updates.hpp"

namespace abrazo::app {

class Job;

/// Writes annotations of takes into the library of the running session on a worker, shortly after they
/// change; only the newest are used. The document continues with the result.
class LibraryFeed : public QObject {
  Q_OBJECT
 public:
  explicit LibraryFeed(Document& document, QObject* parent = nullptr);
  ~LibraryFeed() override;

  /// Nothing is pending.
  bool isIdle() const { return m_updates.is_idle(); }

 signals:
  /// A role of a take is invalid, or the library cannot be made.
  void failed(const QString& why);

 private:
  void put(const std::string& take);
  void forget();
  void begin();

  Document& m_document;
  LibraryUpdates m_updates;
  std::unique_ptr<Job> m_job;
  QTimer m_soon;  ///< merges successive changes
};

}  // namespace abrazo::app
