#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "widgets/common/palette.hpp"
#include "widgets/stream/stream_words.hpp"

namespace abrazo::widgets {

/// The state of the connection: sign, word, address. Always of the same height.
class StreamHead : public QWidget {
  Q_OBJECT
 public:
  explicit StreamHead(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(const StreamHeadline& headline);
  const StreamHeadline& shown() const { return m_headline; }

  QSize sizeHint() const override { return {300, 46}; }
  QSize minimumSizeHint() const override { return {160, 46}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Palette m_palette;
  StreamHeadline m_headline;
};

}  // namespace abrazo::widgets
