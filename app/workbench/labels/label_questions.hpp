#pragma once

#include <QObject>
#include <functional>
#include <map>
#include <string>

#include "core/annotation/label_edits.hpp"

class QMenu;
class QPoint;

namespace abrazo::app {

class AnnotationDesk;
class Document;
class MainWindow;

/// Input for label edits: the value, in a picker at the lane, and the operation, in a menu.
class LabelQuestions : public QObject {
  Q_OBJECT
 public:
  LabelQuestions(MainWindow& window, AnnotationDesk& desk);

  /// Asks for the value of a new label, from in to out, else from the cursor.
  void draw();
  /// Asks for another value of the selected label.
  void ask();
  /// Adds the tiers to which a label can be copied.
  void fillMenu(QMenu& menu);

 private:
  void askValue(int tier, double from_s, double to_s);
  void openMenu(int tier, int annotation, double time_s, const QPoint& global);
  void openPicker(const AnnotationTier& tier, const Annotations::Range& span, const QPoint& place,
                  const QString& value, std::function<Result<LabelEdit>(const std::string&)> edit);

  MainWindow& m_window;
  Document& m_document;
  AnnotationDesk& m_desk;
  std::map<int, std::string> m_used;  ///< value used last, by tier
};

}  // namespace abrazo::app
