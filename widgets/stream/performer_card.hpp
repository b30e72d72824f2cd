#pragma once

#include <QWidget>

#include "core/stream/protocol/stream_health.hpp"
#include "widgets/common/palette.hpp"

class QToolButton;

namespace abrazo::widgets {

class FigureGrid;

/// The part of a performer of the stream.
enum class PerformerPart { None, User, Second };

/// One performer: name, part and figures. Constant height.
class PerformerCard : public QWidget {
  Q_OBJECT
 public:
  explicit PerformerCard(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(const PerformerHealth& performer, PerformerPart part);
  const PerformerHealth& shown() const { return m_performer; }
  PerformerPart part() const { return m_part; }

 signals:
  void partRequested(const QString& performer, abrazo::widgets::PerformerPart part);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QToolButton* makePart(const QString& text, const QString& tip, PerformerPart part);

  Palette m_palette;
  PerformerHealth m_performer;
  PerformerPart m_part = PerformerPart::None;
  QToolButton *m_user, *m_second;
  FigureGrid* m_figures;
};

}  // namespace abrazo::widgets
