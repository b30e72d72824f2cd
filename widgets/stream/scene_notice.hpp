#pragma once

#include <QString>
#include <QWidget>

#include "widgets/common/palette.hpp"
#include "widgets/stream/stream_words.hpp"

namespace abrazo::widgets {

/// What is said over the scene: a badge at its top, or large in its middle. Never takes the pointer.
class SceneNotice : public QWidget {
  Q_OBJECT
 public:
  /// @param over  the scene, which it covers
  explicit SceneNotice(QWidget* over);
  void setColours(const Palette& palette);
  /// In the middle. @param large  a word or a number; empty when only lines are said
  void say(const QString& large, const QString& line, const QString& detail = {});
  /// A line at the top.
  void badge(StreamMark mark, const QString& words);
  void clear();
  /// What is said; empty when nothing is.
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
