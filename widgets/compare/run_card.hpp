#pragma once

#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/compare/figure_rows.hpp"

namespace abrazo::widgets {

/// One of the two runs in two lines: origin and settings, and its first figures.
class RunCard : public QWidget {
  Q_OBJECT
 public:
  /// @param letter "A" or "B"; A has a dashed mark, like its lines and ghost
  explicit RunCard(const QString& letter, QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// @param origin "frozen at 12.3 s", "live"; @param settings settings that differ from the other
  void showRun(const QString& origin, const QString& settings);
  /// Shows the first of these; empty: none yet.
  void showFigures(const std::vector<FigureRow>& figures);

  QSize sizeHint() const override { return {300, m_figures.empty() ? 27 : 46}; }
  QSize minimumSizeHint() const override { return {160, sizeHint().height()}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintFigures(QPainter& painter, QRectF line) const;
  void describe();

  Palette m_palette;
  QString m_letter, m_origin, m_settings;
  std::vector<FigureRow> m_figures;
};

}  // namespace abrazo::widgets
