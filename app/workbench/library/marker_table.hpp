#pragma once

#include <QTableWidget>

#include "core/motion/joints/marker_naming.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::app {

/// The points of a file with their places on the body, one per row. Enter or a click on a proposal accepts
/// it; a place can be typed.
class MarkerTable : public QTableWidget {
  Q_OBJECT
 public:
  enum Column { Point, Place, Belief };

  MarkerTable(const NamedMotion& motion, QWidget* parent);
  void setColours(const widgets::Palette& palette);
  const MarkerNaming& naming() const { return m_naming; }
  /// Shows the proposals of a guess beside the named places.
  void propose(const MarkerGuess& guess);
  /// Reads the places from a model. @return as MarkerNaming::read
  Result<std::size_t> read(const MarkerModel& model);
  /// Of the chosen row or another.
  void accept(int point);

 signals:
  void changed();
  void refused(const QString& why);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void say(int point, const QString& place);
  void showRows();

  MarkerNaming m_naming;
  std::vector<std::string> m_points;
  widgets::Palette m_palette;
  bool m_filling = false;
};

}  // namespace abrazo::app
