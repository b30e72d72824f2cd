#pragma once

#include <QWidget>
#include <functional>

#include "widgets/common/palette.hpp"

class QLabel;
class QPushButton;
class QToolButton;

namespace abrazo::widgets {

/// A sentence with an action: "Written to dance.glb", "Show in folder". Disappears by itself after a while.
class OfferBar : public QWidget {
  Q_OBJECT
 public:
  explicit OfferBar(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// Replaces the present offer. @param tip details, line by line
  void offer(const QString& text, const QString& button, std::function<void()> act, const QString& tip = {});
  QString text() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Palette m_palette;
  QLabel* m_text;
  QPushButton* m_button;
  QToolButton* m_close;
  std::function<void()> m_act;
};

}  // namespace abrazo::widgets
