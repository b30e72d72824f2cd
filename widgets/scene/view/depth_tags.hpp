#pragma once

#include <QPoint>
#include <QString>
#include <vector>

#include "widgets/common/palette.hpp"

class QLabel;
class QWidget;

namespace abrazo::widgets {

/// Short texts beside points of the scene: depths of overlaps. Ignore the pointer.
class DepthTags {
 public:
  static constexpr std::size_t most_tags = 4;
  struct Tag {
    QPoint place;
    QString text;
    bool warns = false;
  };

  explicit DepthTags(QWidget* parent) : m_parent(parent) {}
  void setColours(const Palette& palette);
  /// The first `most_tags` of them.
  void show(const std::vector<Tag>& tags);

 private:
  QWidget* m_parent;
  Palette m_palette = palette_of(Theme::Dark);
  std::vector<QLabel*> m_labels;
};

}  // namespace abrazo::widgets
