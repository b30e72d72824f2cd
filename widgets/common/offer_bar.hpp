#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/common/palette.hpp"

class QLabel;
class QHBoxLayout;
class QPushButton;
class QTimer;
class QToolButton;

namespace abrazo::widgets {

/// A sentence with an action: "Written to dance.glb", "Show in folder". Disappears by itself after a while.
/// Or a question with its answers, which stays.
class OfferBar : public QWidget {
  Q_OBJECT
 public:
  explicit OfferBar(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  /// Replaces the present offer. @param tip details, line by line
  void offer(const QString& text, const QString& button, std::function<void()> act, const QString& tip = {});
  /// A question: stays until it is answered, closed or hidden. @param act gets the chosen answer
  void ask(const QString& text, const QStringList& answers, std::function<void(const QString&)> act);
  QString text() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void showButtons(const QStringList& words);

  Palette m_palette;
  QHBoxLayout* m_row;
  QLabel* m_text;
  std::vector<QPushButton*> m_buttons;  ///< those of the answers, and hidden ones
  QStringList m_answers;
  QToolButton* m_close;
  QTimer* m_leave;
  std::function<void(const QString&)> m_act;
};

}  // namespace abrazo::widgets
