#pragma once

#include <QElapsedTimer>
#include <QString>
#include <QWidget>
#include <cstdint>
#include <vector>

#include "core/session/frames/frame_history.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/plots/plot_series.hpp"

namespace abrazo::app {

/// The status bar's one line: is it keeping up, and does the partner move like a person?
class StatusFigures : public QWidget {
  Q_OBJECT
 public:
  explicit StatusFigures(QWidget* parent = nullptr);
  void setColours(const widgets::Palette& palette);
  void setInput(const QString& name, int library_pairs);
  void setLibrary(int pairs) { m_pairs = pairs; }
  /// @param comes  whether anything comes in from it now
  void showInput(const QString& name, bool comes);
  void refresh(const FrameHistory& history, std::uint64_t rendered_frames);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Figure {
    QString name, value;
  };
  widgets::Palette m_palette;
  QString m_input;
  int m_pairs = 0;
  bool m_ok = true, m_comes = true;
  std::vector<Figure> m_left, m_right;
  std::uint64_t m_nextIndex = 0;
  std::uint64_t m_rendered = 0;
  double m_renderRate = 0;
  QElapsedTimer m_sinceRefresh;
  std::vector<double> m_solve_us;   ///< of the last while
  std::vector<double> m_speed_m_s;  ///< of the partner, the same
  widgets::SeriesReader m_series;
};

/// The value below which `share` of the values are; 0 without values.
double percentile(std::vector<double> values, double share);

}  // namespace abrazo::app
