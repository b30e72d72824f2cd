#include "app/workbench/base/character_field.hpp"

#include <QFileInfo>
#include <QLineEdit>

#include "app/workbench/base/choose_button.hpp"
#include "widgets/common/file_dialog.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::app {

CharacterField::CharacterField(QWidget* parent) : QWidget(parent) {
  const QString name = "Character";
  m_path = new QLineEdit(this);
  m_path->setPlaceholderText("none: the 25 joints");
  widgets::describe(*m_path, name,
                    "A humanoid of another program (GLB, VRM) that performs the motion with its bones");
  m_path->setClearButtonEnabled(true);
  setFocusProxy(m_path);
  auto* choose = choose_button(name, this);
  auto* row = widgets::row_in(this);
  row->addWidget(m_path, 1);
  row->addWidget(choose);
  connect(m_path, &QLineEdit::textChanged, this, &CharacterField::changed);
  connect(choose, &QToolButton::clicked, this, &CharacterField::choose);
}

QString CharacterField::file() const {
  return m_path->text().trimmed();
}

void CharacterField::setFile(const QString& file) {
  m_path->setText(file);
}

QString CharacterField::trouble() const {
  if (file().isEmpty() || QFileInfo(file()).isFile()) return {};
  return "there is no character file " + file();
}

void CharacterField::choose() {
  const QString chosen =
      widgets::choose_file(this, "A humanoid character", m_folder, "Characters (*.glb *.vrm);;All files (*)");
  if (!chosen.isEmpty()) setFile(chosen);
}

}  // namespace abrazo::app
