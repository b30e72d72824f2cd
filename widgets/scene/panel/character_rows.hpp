#pragma once

#include <QWidget>
#include <array>
#include <string>

class QPushButton;
class QToolButton;

namespace abrazo::widgets {

/// For each character the file that it wears, and the way to choose another or to take it off. Reads no file:
/// it emits requests.
class CharacterRows : public QWidget {
  Q_OBJECT
 public:
  explicit CharacterRows(QWidget* parent = nullptr);
  /// @param files  active then passive; empty = capsules
  void setFiles(const std::array<std::string, 2>& files);

 signals:
  /// @param body  0 = active, 1 = passive
  void characterRequested(int body);
  void capsulesRequested(int body);

 private:
  std::array<QPushButton*, 2> m_names{};
  std::array<QToolButton*, 2> m_off{};
};

}  // namespace abrazo::widgets
