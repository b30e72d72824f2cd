#pragma once

#include <QString>
#include <QWidget>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// Header of a panel: 11 px capitals.
class SectionHeader : public QWidget {
  Q_OBJECT
 public:
  explicit SectionHeader(const QString& title, QWidget* parent = nullptr);
  void setTitle(const QString& title);
  const QString& title() const { return m_title; }
  void setColours(const Palette& palette);
  QSize sizeHint() const override { return {160, 32}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString m_title;
  QColor m_colour;
};

}  // namespace abrazo::widgets
