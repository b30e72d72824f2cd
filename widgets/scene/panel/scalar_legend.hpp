#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/scene/values/mesh_scalar.hpp"

class QToolButton;

namespace abrazo::widgets {

/// A labelled colour map.
struct LegendScale {
  QString title, low, high;
  bool is_diverging = false;
  ColourMap map = ColourMap::Viridis;
  QString middle = {};        ///< of a logarithmic map
  bool lacks_values = false;  ///< some values are NaN: the legend shows their colour
  double upper = 0;           ///< end that a person can set, in the unit of the title; 0 = none
  double lower = 0;           ///< the other end of a linear map from 0 on
  bool has_lower = false;     ///< a person can set that as well
  MapPart part = {};          ///< of a map that is not diverging
  bool operator==(const LegendScale&) const = default;
};

/// @param lacks_values some coloured items have no value
LegendScale scalar_legend(MeshScalar scalar, const ColourScale& scale, bool lacks_values);
/// @param doublings  |log2 ratio| at the ends
LegendScale volume_legend(double doublings);

/// Legend of colours: title with unit, colour bar, its two ends, a lock for the range, and the choice of the
/// map. A double click sets the range.
class ScalarLegend : public QWidget {
  Q_OBJECT
 public:
  explicit ScalarLegend(QWidget* parent);
  void setColours(const Palette& palette);
  void show(const LegendScale& scale);
  /// Without its buttons: in a picture nobody can press them.
  void becomePicture();
  /// Sets the lock without a signal.
  void setLocked(bool locked);
  /// Checked entries of the menu.
  void setMap(ColourMap map, bool logarithmic);
  const LegendScale& scale() const { return m_scale; }
  /// Opens a field for the range, if the scale has one.
  void askRange();

 signals:
  void lockToggled(bool locked);
  /// In the unit of the title; the range is kept from then on. @param upper  positive, above `lower`
  void rangeRequested(double lower, double upper);
  void mapRequested(abrazo::widgets::ColourMap map, bool logarithmic);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void dressButtons();
  void showMenu(const QPoint& global);
  Palette m_palette;
  LegendScale m_scale;
  ColourMap m_map = ColourMap::Viridis;
  bool m_isLogarithmic = false, m_isPicture = false;
  QToolButton *m_lock, *m_more;
};

}  // namespace abrazo::widgets
