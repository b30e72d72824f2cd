#pragma once

#include <QListWidget>

#include "widgets/annotation/problem_fixes.hpp"
#include "widgets/common/annotation_types.hpp"

namespace abrazo::widgets {

/// Problems of the annotations of a subject. A click goes to the problem; Return, a double click and the menu
/// fix it if possible.
class ProblemList : public QListWidget {
  Q_OBJECT
 public:
  explicit ProblemList(QWidget* parent = nullptr);
  void show(const Annotations& annotations, const Annotations::Range& range, double fps);
  int count() const { return static_cast<int>(m_problems.size()); }

 signals:
  void seekRequested(double time_s);
  void problemChosen(int tier, int annotation);
  void changeRequested(const abrazo::Annotations& next, const QString& what);
  void refused(const QString& why);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void mend(int row, ProblemFix fix);
  void mendFirst(int row);

  Annotations m_annotations;
  Annotations::Range m_range;
  double m_fps = 0;
  std::vector<AnnotationProblem> m_problems;
};

}  // namespace abrazo::widgets
