#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"

class QToolButton;

namespace abrazo::widgets {

/// A colour map with words.
struct LegendScale {
  QString title, low, high;
  bool is_diverging = false;
  ColourMap map = ColourMap::Viridis;
  QString middle = {};        ///< of a logarithmic map
  bool lacks_values = false;  ///< some are not numbers: the legend tells their colour
  bool operator==(const LegendScale&) const = default;
};

/// @param lacks_values  some of what is coloured has no value
LegendScale scalar_legend(MeshScalar scalar, const ColourScale& scale, bool lacks_values);
/// @param doublings  |log2 ratio| at the ends
LegendScale volume_legend(double doublings);

/// What colours mean: title with unit, colour bar, its two ends, a lock that keeps the range, and the choice
/// of the map.
class ScalarLegend : public QWidget {
  Q_OBJECT
 public:
  explicit ScalarLegend(QWidget* parent);
  void setColours(const Palette& palette);
  void show(const LegendScale& scale);
  /// Sets the lock without saying so.
  void setLocked(bool locked);
  /// What the menu has ticked.
  void setMap(ColourMap map, bool logarithmic);
  const LegendScale& scale() const { return m_scale; }

 signals:
  void lockToggled(bool locked);
  void mapRequested(abrazo::widgets::ColourMap map, bool logarithmic);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void dressButtons();
  void showMenu(const QPoint& global);
  Palette m_palette;
  LegendScale m_scale;
  ColourMap m_map = ColourMap::Viridis;
  bool m_isLogarithmic = false;
  QToolButton *m_lock, *m_more;
};

}  // namespace abrazo::widgets
