#pragma once

#include <QStringList>
#include <QWidget>
#include <vector>

#include "core/session/frames/command.hpp"
#include "core/stream/protocol/stream_health.hpp"
#include "widgets/common/palette.hpp"
#include "widgets/stream/sink_rates.hpp"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace abrazo::widgets {

class AddressForm;
class FigureGrid;
class IssueList;
class NumberRow;
class PerformerCard;
class SectionHeader;
class SinkList;
class StreamHead;
enum class PerformerPart;

/// The live stream: address, quality, performers, problems with advice; and the sinks of characters. Shows
/// values; requests everything by signals.
class ConnectionPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ConnectionPanel(QWidget* parent = nullptr);
  void setColours(const Palette& palette);
  AddressForm& form() { return *m_form; }
  SinkList& sinks() { return *m_sinks; }

  /// @param health null = not connected
  void showHealth(const StreamHealth* health);
  const StreamHealth& shown() const { return m_health; }
  /// Parts of the performers; empty: user = the first that appears, second = none.
  void setParts(const QString& user, const QString& second);
  /// Result of the last calibration, and whether one is running.
  void showCalibration(const QString& words, bool under_way);
  void setDelay(int ms);
  /// @param hz 0 = rate of the input
  void setStepRate(double hz);
  void showSinks(const std::vector<SinkRow>& rows);
  std::vector<PerformerCard*> cards() const { return m_cards; }

 signals:
  void userChosen(const QString& performer);
  /// @param performer empty = none
  void secondChosen(const QString& performer);
  void calibrateRequested();
  void forgetRequested();
  void delayRequested(int ms);
  /// @param value in the format of the setting
  void stepRateRequested(const QString& value);

 private:
  QWidget* section(const QString& title);
  QWidget* makeCalibration();
  QWidget* makeTiming();
  QWidget* makeReport();
  void showPerformers();
  void choose(const QString& performer, PerformerPart part);

  Palette m_palette;
  StreamHealth m_health;
  bool m_connected = false;
  QString m_user, m_second;
  std::vector<SectionHeader*> m_heads;
  std::vector<PerformerCard*> m_cards;
  StreamHead* m_head;
  AddressForm* m_form;
  QVBoxLayout* m_performers;
  QLabel *m_nobody, *m_calibration, *m_said;
  QPushButton *m_calibrate, *m_forget, *m_copy;
  NumberRow* m_delay;
  QComboBox* m_stepRate;
  IssueList* m_issues;
  FigureGrid* m_traffic;
  SinkList* m_sinks;
};

}  // namespace abrazo::widgets
