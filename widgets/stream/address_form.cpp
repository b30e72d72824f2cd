#include "widgets/stream/address_form.hpp"

#include <QComboBox>
#include <QGridLayout>
#include <QIntValidator>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStackedWidget>

#include "widgets/common/file_dialog.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/theme.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::widgets {
namespace {

enum MorePage { Group, File };

QLineEdit* field(QWidget* parent, const QString& name, const QString& tip) {
  auto* made = new QLineEdit(parent);
  describe(*made, name, tip);
  return made;
}

/// Never requests more room than available, so that a long text does not widen the panel.
QLabel* line_of(QWidget* parent) {
  auto* label = quiet_label({}, parent);
  label->setWordWrap(true);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  label->setFixedHeight(34);
  return label;
}

}  // namespace

AddressForm::AddressForm(QWidget* parent) : QWidget(parent), m_palette(palette_of(Theme::Dark)) {
  makeFields();
  lay();
  showScheme(m_address.scheme);
  fieldsChanged();
}

void AddressForm::makeFields() {
  m_scheme = new QComboBox(this);
  m_scheme->setAccessibleName("Kind of stream");
  for (const SchemeFacts& facts : stream_schemes()) m_scheme->addItem(text(facts.title));
  m_host = field(this, "Address", {});
  m_port = field(this, "Port", "UDP port; empty: the protocol's usual one");
  m_port->setValidator(new QIntValidator(1, 65535, m_port));
  m_port->setFixedWidth(72);
  m_group = field(this, "Multicast group", "Where Motive streams to; empty: unicast");
  m_group->setPlaceholderText("unicast, or group such as 239.255.42.99");
  m_file = field(this, "Clip", "A motion (.bvh, .amc) that is replayed");
  m_uri = new QComboBox(this);
  m_uri->setEditable(true);
  m_uri->setInsertPolicy(QComboBox::NoInsert);
  m_uri->setMinimumContentsLength(8);
  m_uri->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  m_uri->setAccessibleName("URI of the stream");
  m_uri->lineEdit()->setAccessibleName("URI of the stream");
  m_uri->setToolTip("The same as one line, to paste and to copy; the list has the recent ones");
  m_note = line_of(this);
  m_connect = new QPushButton("Connect", this);
  m_connect->setFixedWidth(104);
  connect(m_scheme, qOverload<int>(&QComboBox::activated), this, [this](int which) {
    m_address = {};
    m_address.scheme = static_cast<StreamUri::Scheme>(which);
    m_host->clear();
    m_port->clear();
    showScheme(m_address.scheme);
    fieldsChanged();
  });
  for (QLineEdit* each : {m_host, m_port, m_group, m_file}) {
    connect(each, &QLineEdit::textEdited, this, &AddressForm::fieldsChanged);
    connect(each, &QLineEdit::returnPressed, this, &AddressForm::press);
  }
  connect(m_uri->lineEdit(), &QLineEdit::textEdited, this, &AddressForm::uriChanged);
  connect(m_uri->lineEdit(), &QLineEdit::returnPressed, this, &AddressForm::press);
  connect(m_uri, qOverload<int>(&QComboBox::activated), this,
          [this](int) { uriChanged(m_uri->currentText()); });
  connect(m_connect, &QPushButton::clicked, this, [this] {
    if (m_connected)
      emit disconnectRequested();
    else
      press();
  });
}

void AddressForm::lay() {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 4, 12, 4);
  grid->setHorizontalSpacing(6);
  grid->setVerticalSpacing(6);
  grid->setColumnStretch(0, 1);
  m_more = new QStackedWidget(this);
  m_more->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  m_more->setFixedHeight(34);
  m_more->addWidget(m_group);
  auto* file = new QWidget(m_more);
  auto* row = row_in(file, {}, 6);
  auto* choose = new QPushButton("Choose…", file);
  choose->setAccessibleName("Choose a clip");
  connect(choose, &QPushButton::clicked, this, &AddressForm::chooseFile);
  row->addWidget(m_file, 1);
  row->addWidget(choose);
  m_more->addWidget(file);
  grid->addWidget(m_scheme, 0, 0);
  grid->addWidget(m_connect, 0, 1, Qt::AlignRight);
  auto* place = nested_row({}, 6);
  place->addWidget(m_host, 1);
  place->addWidget(m_port);
  grid->addLayout(place, 1, 0, 1, 2);
  grid->addWidget(m_more, 2, 0, 1, 2);
  grid->addWidget(m_uri, 3, 0, 1, 2);
  grid->addWidget(m_note, 4, 0, 1, 2);
  setTabOrder(m_scheme, m_host);
  setTabOrder(m_host, m_port);
  setTabOrder(m_port, m_group);
  setTabOrder(m_group, m_uri);
  setTabOrder(m_uri, m_connect);
}

void AddressForm::setColours(const Palette& palette) {
  m_palette = palette;
  showComplaint(m_wrong);
}

void AddressForm::setRecent(const QStringList& uris) {
  const QString typed = m_uri->currentText();
  m_uri->clear();
  m_uri->addItems(uris);
  m_uri->setEditText(typed);
}

void AddressForm::setConnected(bool connected) {
  m_connected = connected;
  m_connect->setText(connected ? "Disconnect" : "Connect");
}

void AddressForm::setUri(const QString& uri) {
  m_uri->setEditText(uri);
  uriChanged(uri);
}

QString AddressForm::uri() const {
  return m_uri->currentText().trimmed();
}

QString AddressForm::complaint() const {
  return m_wrong;
}

void AddressForm::takeFocus() {
  m_uri->lineEdit()->setFocus();
  m_uri->lineEdit()->selectAll();
}

void AddressForm::fieldsChanged() {
  m_address.host = m_host->text().trimmed().toStdString();
  m_address.port = m_port->text().toInt();
  m_address.group =
      m_address.scheme == StreamUri::Scheme::NatNet ? m_group->text().trimmed().toStdString() : "";
  m_address.file = m_file->text().toStdString();
  m_uri->setEditText(QString::fromStdString(uri_of(m_address)));
  showComplaint({});
}

void AddressForm::uriChanged(const QString& uri) {
  const auto address = address_of(uri.trimmed().toStdString());
  if (!address) return showComplaint(QString::fromStdString(address.error().text()));
  m_address = *address;
  showComplaint({});
  const auto show = [](QLineEdit* in, const QString& text) {
    if (in->text() != text) in->setText(text);
  };
  showScheme(m_address.scheme);
  show(m_host, QString::fromStdString(m_address.host));
  show(m_port, m_address.port > 0 ? QString::number(m_address.port) : QString());
  show(m_group, QString::fromStdString(m_address.group));
  show(m_file, QString::fromStdString(m_address.file));
}

void AddressForm::showScheme(StreamUri::Scheme scheme) {
  const SchemeFacts& facts = facts_of(scheme);
  const bool is_clip = scheme == StreamUri::Scheme::Clip;
  m_scheme->setCurrentIndex(static_cast<int>(scheme));
  m_host->setEnabled(!is_clip);
  m_port->setEnabled(!is_clip);
  m_host->setPlaceholderText(is_clip ? QString() : text(usual_stream_host));
  m_port->setPlaceholderText(is_clip ? QString() : QString::number(facts.port));
  m_host->setToolTip(is_clip             ? ""
                     : facts.asks_server ? "Address of the machine that runs Motive"
                                         : "Address that this machine listens on: 127.0.0.1 for this machine "
                                           "only, 0.0.0.0 for every network");
  m_more->setCurrentIndex(is_clip ? File : Group);
  m_more->setVisible(is_clip || scheme == StreamUri::Scheme::NatNet);
}

void AddressForm::showComplaint(const QString& words) {
  m_wrong = words;
  const QString note = words.isEmpty() ? QString::fromStdString(reach_of(m_address)) : words;
  m_note->setText(note);
  describe(*m_note, words.isEmpty() ? "What the address means" : "What is wrong with the address",
           plain_tip(note));
  m_note->setStyleSheet(words.isEmpty() ? QString() : QString("color: %1").arg(m_palette.warning.name()));
}

void AddressForm::press() {
  uriChanged(uri());
  if (complaint().isEmpty()) emit connectRequested(uri());
}

void AddressForm::chooseFile() {
  const QString file = choose_file(this, "Clip to replay", {}, "Motions (*.bvh *.amc)");
  if (file.isEmpty()) return;
  m_file->setText(file);
  fieldsChanged();
}

}  // namespace abrazo::widgets
