#pragma once

#include <QObject>
#include <QPoint>
#include <map>
#include <string>

#include "core/annotation/annotations.hpp"

class QMenu;

namespace abrazo::app {

class AnnotationDesk;
class MainWindow;

/// What a person does with the labels of the shown subject by actions and in the lanes: each is one change of
/// the desk, and reports what is not possible.
class LabelEdits : public QObject {
  Q_OBJECT
 public:
  LabelEdits(MainWindow& window, AnnotationDesk& desk);

  /// Between in and out, else from the cursor on; what it says is asked for.
  void draw();
  /// Another value of the selected label.
  void ask();
  void remove();
  /// The nearer edge of the selected label goes to the cursor; without one, the label before it.
  void extend();
  void split();
  void merge();
  enum class Edge { Both, Start, End };
  void nudge(Edge edge, int frames);
  /// The next or previous label of the active tier is selected and gone to.
  void step(int by);
  void stepTier(int by);
  void copyTo(int tier);
  /// From the cursor on the other one leads, to the end of the interval it is in.
  void exchangeRole();
  /// Fills in what can be done with a label.
  void fillMenu(QMenu& menu);

 private:
  void askValue(int tier, double from_s, double to_s);
  QString take(int tier, double from_s, double to_s, const QString& value);
  void openMenu(int tier, int annotation, double time_s, const QPoint& global);
  const Annotation* wanted() const;
  bool isThere(const Annotation* annotation) const;

  MainWindow& m_window;
  AnnotationDesk& m_desk;
  std::map<int, std::string> m_used;  ///< value used last, by tier
};

}  // namespace abrazo::app
