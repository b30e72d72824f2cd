#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/sweep/sweep_grid.hpp"
#include "widgets/sweep/sweep_request.hpp"

class QLabel;
class QProgressBar;
class QPushButton;

namespace abrazo::widgets {

class HeatMap;
class SweepForm;

/// Requests a sweep, shows progress and results, and passes on the adopted cell.
class SweepPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SweepPanel(QWidget* parent = nullptr);
  SweepForm& form() { return *m_form; }
  HeatMap& map() { return *m_map; }
  void setColours(const Palette& palette);
  /// Estimated cost of the request, or why it cannot run.
  void showEstimate(const QString& words, bool usable);
  void showGrid(const SweepGrid& grid);
  /// @param fraction  done, 0 to 1
  void showProgress(double fraction, const QString& words);
  void setRunning(bool running);

 signals:
  void edited();  ///< the form changed
  void startRequested(const abrazo::widgets::SweepRequest& request);
  void cancelRequested();
  void adoptRequested(int point);
  void exportRequested();
  void metricChosen(const QString& name);

 private:
  QWidget* buttons();
  QWidget* findings();
  void tell();

  SweepForm* m_form;
  HeatMap* m_map;
  QLabel *m_estimate = nullptr, *m_best = nullptr, *m_cell = nullptr;
  QPushButton *m_start = nullptr, *m_adopt = nullptr, *m_export = nullptr;
  QProgressBar* m_progress = nullptr;
  QColor m_warning, m_secondary;
  int m_hovered = -1;
  bool m_running = false, m_usable = false;
};

}  // namespace abrazo::widgets
