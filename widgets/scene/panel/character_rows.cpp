#include "widgets/scene/panel/character_rows.hpp"

#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {

CharacterRows::CharacterRows(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 2, 10, 2);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  const std::array<QString, 2> bodies = {"Leader", "Follower"};
  for (int body = 0; body < 2; ++body) {
    const auto at = static_cast<std::size_t>(body);
    auto* label = new QLabel(bodies[at], this);
    label->setFont(interface_font(12));
    auto* name = m_names[at] = new QPushButton(this);
    name->setFont(interface_font(12));
    name->setAccessibleName("Character of the " + bodies[at].toLower());
    name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    label->setBuddy(name);
    auto* off = m_off[at] = new QToolButton(this);
    off->setText("×");
    off->setAutoRaise(true);
    off->setToolTip("Show capsules again");
    off->setAccessibleName("Capsules for the " + bodies[at].toLower());
    grid->addWidget(label, body, 0);
    grid->addWidget(name, body, 1);
    grid->addWidget(off, body, 2);
    connect(name, &QPushButton::clicked, this, [this, body] { emit characterRequested(body); });
    connect(off, &QToolButton::clicked, this, [this, body] { emit capsulesRequested(body); });
  }
  setFiles({});
}

void CharacterRows::setFiles(const std::array<std::string, 2>& files) {
  for (std::size_t body = 0; body < 2; ++body) {
    const QString file = QString::fromStdString(files[body]);
    QString name = QFileInfo(file).fileName();
    m_names[body]->setText(file.isEmpty() ? QString("Character…") : name.replace('&', "&&"));
    m_names[body]->setToolTip(file.isEmpty()
                                  ? "Shows a humanoid of another program (GLB, VRM) instead of capsules"
                                  : file.toHtmlEscaped());
    m_off[body]->setVisible(!file.isEmpty());
  }
}

}  // namespace abrazo::widgets
