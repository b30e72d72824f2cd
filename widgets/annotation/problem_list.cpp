#include "widgets/annotation/problem_list.hpp"

#include <QContextMenuEvent>
#include <QKeyEvent>
#include <QMenu>
#include <algorithm>

namespace abrazo::widgets {

ProblemList::ProblemList(QWidget* parent) : QListWidget(parent) {
  setAccessibleName("Problems");
  setFrameShape(QFrame::NoFrame);
  setWordWrap(true);
  setAlternatingRowColors(false);
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
    // A copy, because receivers may immediately show other problems.
    const AnnotationProblem problem = m_problems[static_cast<std::size_t>(row(item))];
    emit problemChosen(problem.tier, problem.annotation);
    emit seekRequested(problem.start_s);
  });
  connect(this, &QListWidget::itemDoubleClicked, this,
          [this](QListWidgetItem* item) { mendFirst(row(item)); });
}

void ProblemList::show(const Annotations& annotations, const Annotations::Range& range, double fps) {
  m_annotations = annotations;
  m_range = range;
  m_fps = fps;
  m_problems = problems_of(annotations, range, fps);
  const int at = currentRow();
  clear();
  for (const AnnotationProblem& problem : m_problems) {
    const auto fixes = fixes_of(problem, annotations);
    QString words = QString::fromStdString(problem.text);
    if (!fixes.empty()) words += "  ↵ " + QString::fromStdString(words_of(fixes.front()));
    addItem(words);
  }
  if (at >= 0) setCurrentRow(std::min(at, QListWidget::count() - 1));
}

void ProblemList::mend(int row, ProblemFix fix) {
  if (row < 0 || row >= count()) return;  // others were shown while the menu was open
  const auto next = fixed(m_annotations, m_problems[static_cast<std::size_t>(row)], fix, m_range, m_fps);
  next ? emit changeRequested(*next, QString::fromStdString(words_of(fix)))
       : emit refused(QString::fromStdString(next.error().text()));
}

void ProblemList::mendFirst(int row) {
  if (row < 0 || row >= count()) return;
  const auto fixes = fixes_of(m_problems[static_cast<std::size_t>(row)], m_annotations);
  fixes.empty() ? emit refused("No automatic fix: edit the labels yourself") : mend(row, fixes.front());
}

void ProblemList::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) return mendFirst(currentRow());
  QListWidget::keyPressEvent(event);
}

void ProblemList::contextMenuEvent(QContextMenuEvent* event) {
  const int at = currentRow();
  if (at < 0 || at >= count()) return;
  QMenu menu(this);
  for (const ProblemFix fix : fixes_of(m_problems[static_cast<std::size_t>(at)], m_annotations)) {
    QString words = QString::fromStdString(words_of(fix));
    words[0] = words[0].toUpper();
    menu.addAction(words, this, [this, at, fix] { mend(at, fix); });
  }
  if (!menu.isEmpty()) menu.exec(event->globalPos());
}

}  // namespace abrazo::widgets
