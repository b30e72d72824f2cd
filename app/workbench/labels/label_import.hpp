#pragma once

#include <QObject>
#include <QStringList>
#include <vector>

#include "core/annotation/label_import.hpp"

namespace abrazo::app {

class AnnotationDesk;
class Document;
class MainWindow;

/// Imports label files into the tiers of the shown subject, as one undo step.
class LabelImport : public QObject {
  Q_OBJECT
 public:
  LabelImport(MainWindow& window, AnnotationDesk& desk);
  /// Opens a file dialog.
  void choose();
  /// Asks for the target tiers if they are ambiguous. Errors and omitted labels are reported.
  void read(const QStringList& files);

 private:
  void take(const QString& file, const TierDocument& document);
  void ask(const QString& file, const TierDocument& document, const TierPlan& plan);
  void finish(const QString& file, const TierDocument& document, const std::vector<TierTarget>& targets);

  MainWindow& m_window;
  Document& m_document;
  AnnotationDesk& m_desk;
};

}  // namespace abrazo::app
