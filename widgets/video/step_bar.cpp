#include "widgets/video/step_bar.hpp"

#include <QToolButton>

#include "core/session/frames/time_place.hpp"
#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/tabular.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/video/video_words.hpp"

namespace abrazo::widgets {

StepBar::StepBar(QWidget* parent) : QWidget(parent) {
  auto* row = row_in(this, {8, 3, 12, 3}, 2);
  m_back = makeStep("Previous picture of the video", -1);
  m_on = makeStep("Next picture of the video", 1);
  m_time = new TabularLabel(this);
  m_time->setFont(interface_font(14));
  m_time->setAccessibleName("Time in the video");
  m_picture = new TabularLabel(this);
  m_picture->setFont(interface_font(12));
  m_picture->setAccessibleName("Picture of the video");
  m_link = new QToolButton(this);
  m_link->setObjectName("chip");
  m_link->setText("Linked");
  m_link->setCheckable(true);
  m_link->setChecked(true);
  m_link->setFocusPolicy(Qt::TabFocus);
  describe(*m_link, "Linked with the timeline",
           "The video follows the timeline's cursor. Off: it is stepped by itself, to find the picture that "
           "belongs "
           "to the cursor");
  row->addWidget(m_back);
  row->addWidget(m_on);
  row->addSpacing(6);
  row->addWidget(m_time);
  row->addSpacing(8);
  row->addWidget(m_picture, 1);
  row->addWidget(m_link);
  connect(m_link, &QToolButton::clicked, this, &StepBar::linkRequested);
  setUsable(false);
}

QToolButton* StepBar::makeStep(const QString& name, int pictures) {
  auto* button = new QToolButton(this);
  button->setObjectName("flat");
  describe(*button, name, name + (pictures < 0 ? " (, in the video)" : " (. in the video)"));
  button->setAutoRepeat(true);
  button->setFocusPolicy(Qt::TabFocus);
  connect(button, &QToolButton::clicked, this, [this, pictures] { emit stepRequested(pictures); });
  return button;
}

void StepBar::setColours(const Palette& palette) {
  m_back->setIcon(icon(Icon::StepBack, palette.text));
  m_on->setIcon(icon(Icon::StepForward, palette.text));
  m_time->setColour(palette.text);
  m_picture->setColour(palette.secondary);
}

void StepBar::showPicture(int index, int pictures, double time_s) {
  m_time->setText(index < 0 ? QString("–:––.–––") : QString::fromStdString(clock_text(time_s)));
  m_picture->setText(index < 0 ? QString() : QString::fromStdString(picture_text(index, pictures)));
}

QString StepBar::text() const {
  return m_time->text() + " " + m_picture->text();
}

void StepBar::setLinked(bool linked) {
  m_link->setChecked(linked);
  m_link->setText(linked ? "Linked" : "By itself");
}

bool StepBar::isLinked() const {
  return m_link->isChecked();
}

void StepBar::setUsable(bool on) {
  for (QToolButton* button : {m_back, m_on, m_link}) button->setEnabled(on);
}

}  // namespace abrazo::widgets
