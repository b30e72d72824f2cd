#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/synthesis/settings.hpp"
#include "widgets/sweep/sweep_request.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QSpinBox;
class QToolButton;

namespace abrazo::widgets {

/// What to sweep: two settings with their values, the figure that is drawn, and the takes that are answered.
class SweepForm : public QWidget {
  Q_OBJECT
 public:
  explicit SweepForm(QWidget* parent = nullptr);
  /// Ranges that were not touched yet are proposed around these; what has no effect with them cannot be
  /// chosen.
  void setSettings(const Settings& settings);
  /// @param proposed  chosen while nothing else was
  void setMetrics(const std::vector<std::string>& names, const std::string& proposed);
  void setTakes(const std::vector<std::string>& names);
  SweepRequest request() const;
  /// The setting of the columns; the rows take another one if it was theirs.
  void setColumns(const std::string& key);
  /// While a sweep runs only the figure can be changed.
  void setRunning(bool running);

 signals:
  void changed();
  void metricChosen(const QString& name);

 private:
  struct Side {
    QComboBox* setting = nullptr;
    QLineEdit *from = nullptr, *to = nullptr;
    QSpinBox* count = nullptr;
    QLabel* scale = nullptr;
    bool touched = false;
  };
  void addSide(Side& side, const QString& name, int row, int chosen);
  void offer(Side& side);
  void propose(Side& side);
  std::string axis(const Side& side) const;
  void refillTakes();
  void nameTakes();

  Settings m_settings;
  Side m_x, m_y;
  QComboBox* m_metric = nullptr;
  QToolButton* m_takesButton = nullptr;
  QMenu* m_takesMenu = nullptr;
  std::vector<std::string> m_takes;
  std::vector<bool> m_answered;
};

}  // namespace abrazo::widgets
