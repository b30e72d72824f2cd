#pragma once

#include <QLineEdit>
#include <string>

namespace abrazo::app {

/// A field that captures the next key press. Tab moves to the next control, as everywhere.
class KeyEntry : public QLineEdit {
  Q_OBJECT
 public:
  explicit KeyEntry(QWidget* parent = nullptr);
  /// Portable text; empty before a key was pressed.
  const std::string& key() const { return m_key; }
  void forget();

 signals:
  void pressed();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  std::string m_key;
};

/// The key in the form used for actions: symbols without Shift, keypad digits as digits. Empty for a modifier
/// alone.
std::string pressed_key(const QKeyEvent& event);

}  // namespace abrazo::app
