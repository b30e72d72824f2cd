#pragma once

#include <QWidget>
#include <vector>

#include "core/synthesis/settings/preset_choice.hpp"

class QMenu;
class QToolButton;

namespace abrazo::widgets {

/// The presets as segments of one button; the last has the user's own presets, with a menu to save, rename,
/// delete, export and import them.
class PresetBar : public QWidget {
  Q_OBJECT
 public:
  explicit PresetBar(QWidget* parent = nullptr);
  void setOwn(std::vector<OwnPreset> own);
  /// @param changed the settings differ from the preset, which gets a star
  void showChoice(const PresetChoice& choice, bool changed);
  /// Fills the menu of the user's own presets, for the menu bar too. @param menu cleared first
  void fillMenu(QMenu& menu);

 signals:
  void chosen(const QString& name);
  void ownChosen(const QString& name);
  void saveRequested();  ///< the receiver asks for the name
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
