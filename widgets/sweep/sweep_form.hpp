#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "core/synthesis/settings/settings.hpp"
#include "widgets/sweep/sweep_request.hpp"

class QComboBox;
class QLabel;
class QLineEdit;
class QMenu;
class QSpinBox;
class QToolButton;

namespace abrazo::widgets {

/// Parameters of a sweep: two settings with their values, the displayed figure, and the evaluated takes.
class SweepForm : public QWidget {
  Q_OBJECT
 public:
  explicit SweepForm(QWidget* parent = nullptr);
  /// Proposes ranges around these settings unless the user changed them; disables settings without effect.
  void setSettings(const Settings& settings);
  /// @param proposed default until the user chooses another
  void setMetrics(const std::vector<std::string>& names, const std::string& proposed);
  void setTakes(const std::vector<std::string>& names);
  SweepRequest request() const;
  /// Sets the setting of the columns; if the rows had it, they get another.
  void setColumns(const std::string& key);
  /// During a sweep only the figure can be changed.
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
