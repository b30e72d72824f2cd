#pragma once

#include <QPixmap>
#include <QWidget>
#include <memory>
#include <vector>

#include "core/library/motion_library.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// The takes of the library, each with a small picture of a pair in its middle.
class TakeList : public QWidget {
  Q_OBJECT
 public:
  explicit TakeList(QWidget* parent = nullptr);
  void setLibrary(std::shared_ptr<const MotionLibrary> library);
  void setColours(const Palette& palette);
  QSize sizeHint() const override;

 public slots:
  /// The take the shown frame comes from; -1 for none.
  void setCurrentTake(int take);
  /// A take that somebody asked for; -1 for none.
  void setSelectedTake(int take);
  int selectedTake() const { return m_selected; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPixmap thumbnail(int take) const;
  void makeThumbnails();

  Palette m_palette;
  std::shared_ptr<const MotionLibrary> m_library;
  std::vector<QPixmap> m_thumbnails;
  int m_current = -1;
  int m_selected = -1;
};

}  // namespace abrazo::widgets
