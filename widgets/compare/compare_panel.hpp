#pragma once

#include <QWidget>
#include <vector>

#include "core/metrics/run_comparison.hpp"
#include "core/session/frames/comparison_plan.hpp"
#include "widgets/common/palette.hpp"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace abrazo::widgets {

class CompareCurve;
class FigureTable;
class RunCard;

/// Origin and settings of the two runs; plain values.
struct CompareSides {
  QString origin_a, origin_b;      ///< origins: "frozen at 12.3 s", "live"
  QString settings_a, settings_b;  ///< settings that differ from the other
  bool is_frozen = false;          ///< A has frozen settings
  bool is_aside = false;           ///< the live solver keeps A while B is tried
};

/// Two runs over the same inputs side by side: their settings, figures and a curve over time. Requests
/// everything by signals; solves nothing.
class ComparePanel : public QWidget {
  Q_OBJECT
 public:
  explicit ComparePanel(QWidget* parent = nullptr);
  void setColours(const Palette& palette);

  WhatIfSpan span() const;
  void setSpan(WhatIfSpan span);
  /// As if chosen by the user.
  void chooseSpan(WhatIfSpan span);
  const CompareCurve& curve() const { return *m_curve; }
  const FigureTable& table() const { return *m_table; }
  QString note() const;

 public slots:
  void showSides(const abrazo::widgets::CompareSides& sides);
  /// @param note the frames, and remarks about them
  void showFigures(const abrazo::RunFigures& a, const abrazo::RunFigures& b,
                   const std::vector<abrazo::ComparedStep>& steps, const QString& note);
  /// Shows that there is nothing to compare. @param note what to do about it
  void showNothing(const QString& note);
  /// Progress of solving [0, 1]; negative = idle.
  void showProgress(double fraction);
  void showCursor(double time_s);

 signals:
  void freezeRequested();
  void swapRequested();
  void adoptRequested();
  void clearRequested();
  void asideRequested(bool on);
  void spanRequested(abrazo::WhatIfSpan span);
  void cancelRequested();
  void seekRequested(double time_s);

 private:
  QWidget* makeButtons();
  QWidget* makeSpans();
  QWidget* makeProgress();
  QWidget* makeCurveHead();

  QVBoxLayout* m_column = nullptr;
  RunCard *m_a = nullptr, *m_b = nullptr;
  QPushButton *m_freeze = nullptr, *m_swap = nullptr, *m_adopt = nullptr, *m_clear = nullptr;
  QToolButton* m_aside = nullptr;
  std::vector<QToolButton*> m_spans;
  QWidget* m_progressRow = nullptr;
  QProgressBar* m_progress = nullptr;
  QComboBox* m_figure = nullptr;
  CompareCurve* m_curve = nullptr;
  FigureTable* m_table = nullptr;
  QLabel* m_note = nullptr;
};

}  // namespace abrazo::widgets
