#include "app/workbench/takes/pair_dialog.hpp"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "widgets/common/parts.hpp"

namespace abrazo::app {
namespace {

constexpr double usual_trim_s = 0.5;  // from the key to the dance, and back to the key

QDoubleSpinBox* trim(double most_s, const QString& name, QWidget* parent) {
  auto* field = new QDoubleSpinBox(parent);
  field->setRange(0, most_s);
  field->setDecimals(2);
  field->setSingleStep(0.1);
  field->setSuffix(" s");
  field->setAccessibleName(name);
  return field;
}

constexpr ActivePerformer leaders[] = {ActivePerformer::A, ActivePerformer::B, ActivePerformer::Unknown};

}  // namespace

PairDialog::PairDialog(const PairCapture& capture, const QString& name, const QStringList& labels,
                       QWidget* parent)
    : QDialog(parent), m_length_s(capture.state().length_s) {
  setObjectName("pairDialog");
  setWindowTitle("Add the pair to the library");
  const QString a = QString::fromStdString(capture.a()), b = QString::fromStdString(capture.b());
  m_name = new QLineEdit(name, this);
  m_leads = new QComboBox(this);
  m_leads->addItems({a + " leads", b + " leads", "unknown: either"});
  m_leads->setToolTip(
      "Who is the active performer. Unknown keeps both assignments, and the pairs count twice");
  m_label = new QComboBox(this);
  widgets::make_typeable(*m_label);
  m_label->addItems(QStringList{""} + labels);
  m_label->lineEdit()->setPlaceholderText("several, or none");
  m_label->setToolTip("The move of the whole take; empty if there are several");
  m_in = trim(m_length_s, "Cut off at the beginning", this);
  m_out = trim(m_length_s, "Cut off at the end", this);
  m_name->setAccessibleName("Name");
  m_leads->setAccessibleName("Role");
  m_label->setAccessibleName("Move");
  if (m_length_s > 4 * usual_trim_s) {
    m_in->setValue(usual_trim_s);
    m_out->setValue(usual_trim_s);
  }
  m_length = widgets::quiet_label({}, this);
  m_trouble = new QLabel(this);
  m_trouble->setWordWrap(true);
  m_trouble->hide();
  auto* form = new QFormLayout;
  form->addRow("Name", m_name);
  form->addRow("Role", m_leads);
  form->addRow("Move", m_label);
  form->addRow("Cut off at the beginning", m_in);
  form->addRow("Cut off at the end", m_out);
  form->addRow("", m_length);
  auto* buttons = new QDialogButtonBox(this);
  auto* add = buttons->addButton("Add to library", QDialogButtonBox::AcceptRole);
  add->setDefault(true);
  buttons->addButton("Do not add", QDialogButtonBox::RejectRole);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(m_trouble);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &PairDialog::addRequested);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (QDoubleSpinBox* field : {m_in, m_out})
    connect(field, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &PairDialog::showLength);
  showLength();
}

void PairDialog::setLeader(ActivePerformer leader) {
  m_leads->setCurrentIndex(static_cast<int>(std::ranges::find(leaders, leader) - std::begin(leaders)));
}

PairCapture::Wishes PairDialog::wishes() const {
  return {m_name->text().trimmed().toStdString(), leaders[m_leads->currentIndex()],
          m_label->currentText().trimmed().toStdString(), m_in->value(), m_out->value()};
}

void PairDialog::showLength() {
  const double used_s = m_length_s - m_in->value() - m_out->value();
  m_length->setText(
      QString("%1 s of %2 s are used").arg(std::max(0.0, used_s), 0, 'f', 1).arg(m_length_s, 0, 'f', 1));
}

void PairDialog::showTrouble(const QString& text) {
  m_trouble->setText("⚠ " + text);
  m_trouble->show();
}

QString PairDialog::trouble() const {
  return m_trouble->text();
}

}  // namespace abrazo::app
