#pragma once

#include <QWidget>

#include "widgets/common/palette.hpp"

namespace abrazo::widgets {
class BodyBox;
class ValueSlider;
}  // namespace abrazo::widgets

namespace abrazo::app {

/// The body that a recorded performer gets: as text, as a file, or by a slider of its size.
class BodyField : public QWidget {
  Q_OBJECT
 public:
  static constexpr double slider_least = 0.5, slider_greatest = 1.5;

  /// @param name  for a screen reader, "Leader's body"
  BodyField(const QString& name, QWidget* parent);
  void setColours(const widgets::Palette& palette);
  /// Where the choice of a file starts.
  void setFolder(const QString& folder) { m_folder = folder; }
  /// As `parse_body_choice` reads it.
  QString text() const;

 signals:
  void changed();

 private:
  void slideTo(double place);
  void showSize();
  void chooseFile();

  widgets::BodyBox* m_box;
  widgets::ValueSlider* m_size;
  QString m_folder;
};

}  // namespace abrazo::app
