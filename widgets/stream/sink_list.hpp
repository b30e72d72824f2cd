#pragma once

#include <QWidget>
#include <vector>

#include "core/session/frames/command.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/stream/sink_rates.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace abrazo::widgets {

class SinkCard;

/// The sinks of characters, and a form to add one.
class SinkList : public QWidget {
  Q_OBJECT
 public:
  explicit SinkList(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  void show(const std::vector<SinkRow>& rows);
  /// "vmc://127.0.0.1:39540?framing=t-last" of the form.
  QString uri() const;
  void setAddress(const QString& host, int port);
  void askStop(const QString& uri) { emit stopRequested(uri); }
  void takeFocus();

 signals:
  void sendRequested(const QString& uri, abrazo::Character character);
  void stopRequested(const QString& uri);

 private:
  QWidget* makeForm();

  Palette m_palette;
  std::vector<SinkCard*> m_cards;
  QVBoxLayout* m_column;
  QLabel* m_none;
  QComboBox *m_character, *m_framing;
  QLineEdit *m_host, *m_port;
};

}  // namespace abrazo::widgets
