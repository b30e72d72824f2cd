#pragma once

#include <QString>
#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/stream/stream_words.hpp"

namespace abrazo::widgets {

/// A notice over the scene: a badge at the top, or large text in the middle. Ignores the pointer.
class SceneNotice : public QWidget {
  Q_OBJECT
 public:
  /// @param over the covered scene
  explicit SceneNotice(QWidget* over);
  void setColours(const Palette& palette);
  /// Shows text in the middle. @param large a word or number; empty = lines only
  void say(const QString& large, const QString& line, const QString& detail = {});
  /// A line at the top.
  void badge(StreamMark mark, const QString& words);
  void clear();
  /// The shown text; empty if hidden.
  QString words() const;

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void paintBadge(QPainter& painter);
  void present();

  Palette m_palette;
  QString m_large, m_line, m_detail, m_badge;
  StreamMark m_mark = StreamMark::Off;
};

}  // namespace abrazo::widgets
