#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/scene/pick/pick_facts.hpp"

namespace abrazo::widgets {

/// Facts of the hovered or selected item. Ignores the pointer.
class PickCard : public QWidget {
  Q_OBJECT
 public:
  explicit PickCard(QWidget* parent);
  void setColours(const Palette& palette);
  /// Sizes itself to the text.
  void show(const PickText& text);
  /// Lines that are wider than the card may be are broken, a title is shortened.
  void setMostWidth(int width_px);
  int wholeHeight() const;  ///< [px]
  /// Leaves out the last lines that do not fit; the title and the first one stay.
  void limit(int height_px);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void lay();

  Palette m_palette;
  PickText m_text;
  QString m_title;      ///< as it fits
  QStringList m_lines;  ///< as they fit
  int m_mostWidth = QWIDGETSIZE_MAX;
};

}  // namespace abrazo::widgets
