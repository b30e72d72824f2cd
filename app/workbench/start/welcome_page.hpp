#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/common/palette.hpp"

class QCheckBox;
class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace abrazo::widgets {
class SectionHeader;
}

namespace abrazo::app {

/// The welcome page beside the running scene: files to open, recent files, meaning of the colours, first
/// keys.
class WelcomePage : public QWidget {
  Q_OBJECT
 public:
  explicit WelcomePage(QWidget* parent = nullptr);
  void setColours(const widgets::Palette& palette);
  /// @param labels one per recent entry; @param tips the full paths
  void setRecent(const QStringList& labels, const QStringList& tips);
  /// Adds a start action above the recent files.
  void addStart(const QString& text, const QString& key, std::function<void()> act);
  /// @param is_generated  what is open was generated
  void showAbout(bool is_generated);
  void setShownAtStart(bool on);

 signals:
  void recentChosen(int which);
  void shownAtStartChanged(bool on);
  void closeRequested();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  widgets::SectionHeader* section(const QString& title);
  QPushButton* link(const QString& text, const QString& key);
  void addColours();
  void addKeys();

  QVBoxLayout* m_column;
  QVBoxLayout *m_starts, *m_recent;
  std::vector<widgets::SectionHeader*> m_heads;
  std::vector<QLabel*> m_swatches;
  QLabel* m_about;
  QToolButton* m_close;
  QCheckBox* m_atStart;
};

}  // namespace abrazo::app
