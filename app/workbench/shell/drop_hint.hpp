#pragma once

#include <QStringList>
#include <QWidget>

#include "widgets/common/palette.hpp"

namespace abrazo::app {

/// "walk.bvh: a motion, plays the user", for each file being dragged.
QStringList dropped_in_words(const QStringList& files);

/// Overlay of the window while files are dragged over it.
class DropHint : public QWidget {
  Q_OBJECT
 public:
  explicit DropHint(QWidget* window);
  void showFor(const QStringList& files, const widgets::Palette& palette);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QStringList m_words;
  widgets::Palette m_palette;
};

}  // namespace abrazo::app
