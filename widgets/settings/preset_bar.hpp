#pragma once

#include <QWidget>
#include <vector>

#include "core/synthesis/preset_choice.hpp"

class QMenu;
class QToolButton;

namespace abrazo::widgets {

/// The presets as segments of one button; the last holds one's own, with a menu to save, rename, delete,
/// export and import them.
class PresetBar : public QWidget {
  Q_OBJECT
 public:
  explicit PresetBar(QWidget* parent = nullptr);
  void setOwn(std::vector<OwnPreset> own);
  /// @param changed  the settings are no longer the preset's: it gets a star
  void showChoice(const PresetChoice& choice, bool changed);
  /// What the menu of one's own presets offers now, for the menu bar too. @param menu  emptied first
  void fillMenu(QMenu& menu);

 signals:
  void chosen(const QString& name);
  void ownChosen(const QString& name);
  void saveRequested();  ///< under a name that is asked for
  void overwriteRequested(const QString& name);
  void renameRequested(const QString& name);
  void removeRequested(const QString& name);
  void exportRequested();
  void importRequested();

 private:
  void addManagement(QMenu& menu);

  std::vector<QToolButton*> m_given;
  QToolButton* m_ownButton = nullptr;
  QMenu* m_menu = nullptr;
  std::vector<OwnPreset> m_own;
  PresetChoice m_choice;
  bool m_changed = false;
};

}  // namespace abrazo::widgets
