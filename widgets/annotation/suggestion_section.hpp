#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "widgets/annotation/suggestion_rows.hpp"
#include "widgets/common/palette.hpp"

class QLabel;
class QListWidget;
class QProgressBar;
class QSlider;
class QToolButton;

namespace abrazo::widgets {

class SectionHeader;

/// The suggestions for a subject, highest confidence first, with reasons. In the list A accepts, E accepts
/// another value, X rejects, and the next one is shown. Changes nothing itself: it emits requests.
class SuggestionSection : public QWidget {
  Q_OBJECT
 public:
  explicit SuggestionSection(QWidget* parent = nullptr);
  void setColours(const Palette& palette);

  void showSuggestions(const Annotations& annotations);
  /// Shows progress while suggestions are made. @param fraction below 0: idle
  void showProgress(double fraction, const QString& doing);
  void choose(int suggestion);
  /// Id of the chosen suggestion; 0 = none.
  int current() const;
  /// Minimum confidence for "accept all".
  double threshold() const;
  QListWidget& list() const { return *m_list; }
  QSlider& slider() const { return *m_slider; }
  QToolButton& acceptAll() const { return *m_acceptAll; }

 signals:
  void suggestRequested(bool moves, bool roles);
  void cancelRequested();
  void acceptRequested(int suggestion);
  void editRequested(int suggestion);
  void rejectRequested(int suggestion);
  void acceptAllRequested(const std::vector<int>& suggestions);
  void clearRequested();
  void chosen(int suggestion, double start_s);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  QWidget* makeButtons();
  QWidget* makeThreshold();
  void describe();
  void count();
  /// @return whether the list handles the key
  bool press(int key);

  std::vector<SuggestionRow> m_rows;
  SectionHeader* m_head;
  QListWidget* m_list;
  QLabel *m_reason, *m_threshold = nullptr;
  QProgressBar* m_progress;
  QSlider* m_slider = nullptr;
  QToolButton *m_moves = nullptr, *m_roles = nullptr, *m_cancel = nullptr;
  QToolButton *m_accept = nullptr, *m_edit = nullptr, *m_reject = nullptr, *m_acceptAll = nullptr;
  bool m_filling = false;
};

}  // namespace abrazo::widgets
