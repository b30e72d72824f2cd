#include "app/workbench/export/export_dialog.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

#include "app/workbench/base/character_field.hpp"
#include "app/workbench/base/range_words.hpp"
#include "app/workbench/export/export_words.hpp"
#include "widgets/common/parts.hpp"

namespace abrazo::app {
namespace {

constexpr double fastest_hz = 480;

QComboBox* combo(QWidget* parent, const char* name) {
  auto* box = new QComboBox(parent);
  box->setObjectName(name);
  box->setAccessibleName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(44);
  return box;
}

/// So wide that no type is cut, whichever of them are listed.
void make_room_for_types(QComboBox& box) {
  box.addItems(all_export_type_words());
  box.setSizeAdjustPolicy(QComboBox::AdjustToContents);
  box.ensurePolished();
  box.setMinimumWidth(box.sizeHint().width());
  box.clear();
}

/// Chooses the entry with this data, if any.
bool choose(QComboBox* box, const QVariant& data) {
  const int index = box->findData(data);
  if (index >= 0) box->setCurrentIndex(index);
  return index >= 0;
}

}  // namespace

ExportDialog::ExportDialog(QWidget* parent) : QDialog(parent) {
  setObjectName("export");
  setWindowTitle("Export");
  m_form = new QFormLayout(this);
  m_form->setContentsMargins(20, 16, 20, 16);
  m_source = combo(this, "Of");
  m_what = combo(this, "What");
  for (const auto& [name, what] : {std::pair{"Motion of the bodies", Motion},
                                   {"Interaction mesh", Mesh},
                                   {"Labels", Labels},
                                   {"Trace: every frame with its reasons", Trace},
                                   {"Plots as they are shown", Plots}})
    m_what->addItem(name, what);
  m_bodies = new QWidget(this);
  auto* bodies = widgets::row_in(m_bodies);
  m_active = new QCheckBox("Leader", m_bodies);
  m_passive = new QCheckBox("Follower", m_bodies);
  m_user = new QCheckBox("User as received", m_bodies);
  for (QCheckBox* body : {m_active, m_passive, m_user}) {
    bodies->addWidget(body);
    body->setChecked(body == m_passive);
    connect(body, &QCheckBox::toggled, this, &ExportDialog::settle);
  }
  bodies->addStretch(1);
  m_character = new CharacterField(this);
  m_part = combo(this, "Part");
  m_type = combo(this, "As");
  make_room_for_types(*m_type);
  m_tiers = combo(this, "Tiers");
  m_tiers->addItem("All, times in seconds", true);
  m_tiers->addItem("Moves alone, in frames of each take: a label file", false);
  m_rate = new QDoubleSpinBox(this);
  m_rate->setObjectName("Rate");
  m_rate->setAccessibleName("Frames per second");
  m_rate->setRange(0, fastest_hz);
  m_rate->setDecimals(2);
  m_rate->setSuffix(" Hz");
  m_rate->setSpecialValueText("as recorded");
  m_unit = combo(this, "Unit");
  m_unit->addItem("Metres", 1.0);
  m_unit->addItem("Centimetres", 100.0);
  m_up = combo(this, "Up");
  m_up->addItem("Y up", false);
  m_up->addItem("Z up", true);
  m_about = widgets::quiet_label({}, this);
  m_about->setWordWrap(true);
  m_estimate = new QLabel(this);
  m_estimate->setObjectName("estimate");
  m_export = new QPushButton("Export…", this);
  m_export->setDefault(true);
  auto* video = new QPushButton("As video…", this);
  video->setToolTip("Pictures of the scene instead: opens \"Render range\"");
  auto* close = new QPushButton("Close", this);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(video);
  buttons->addStretch(1);
  buttons->addWidget(close);
  buttons->addWidget(m_export);
  m_form->addRow("Of", m_source);
  m_form->addRow("What", m_what);
  m_form->addRow("Bodies", m_bodies);
  m_form->addRow("Character", m_character);
  m_form->addRow("Part", m_part);
  m_form->addRow("As", m_type);
  m_form->addRow("Tiers", m_tiers);
  m_form->addRow("Rate", m_rate);
  m_form->addRow("Unit", m_unit);
  m_form->addRow("Axes", m_up);
  m_form->addRow(QString(), m_about);
  m_form->addRow(QString(), m_estimate);
  m_form->addRow(buttons);
  const auto changed = qOverload<int>(&QComboBox::currentIndexChanged);
  connect(m_source, changed, this, &ExportDialog::sourceChanged);
  connect(m_what, changed, this, [this] {
    showTypes();
    proposeCharacter();
  });
  connect(m_character, &CharacterField::changed, this, [this] {
    m_mayProposeCharacter = false;
    showTypes();
  });
  for (QComboBox* box : {m_part, m_type, m_tiers, m_unit, m_up})
    connect(box, changed, this, &ExportDialog::settle);
  connect(m_type, changed, this, &ExportDialog::proposeCharacter);
  connect(m_rate, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &ExportDialog::settle);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
  connect(video, &QPushButton::clicked, this, &ExportDialog::videoRequested);
  connect(m_export, &QPushButton::clicked, this, &ExportDialog::exportRequested);
  showTypes();
}

ExportDialog::What ExportDialog::what() const {
  return static_cast<What>(m_what->currentData().toInt());
}

void ExportDialog::offer(ExportOffer offer) {
  m_offer = std::move(offer);
  const QVariant source = m_source->currentData();
  m_filling = true;
  m_source->clear();
  if (m_offer.session) m_source->addItem(m_offer.session->name, QString());
  for (const ExportOffer::Stretch& take : m_offer.library_takes)
    m_source->addItem(QString("Take %1 of the library").arg(take.name), take.name);
  choose(m_source, source);
  m_filling = false;
  sourceChanged();
}

void ExportDialog::chooseLabels(const QString& subject) {
  const bool had_labels = what() == Labels;
  choose(m_source, subject);
  choose(m_what, Labels);
  choose(m_part, "all");
  if (!had_labels) choose(m_type, ".eaf");
}

void ExportDialog::chooseTypeOf(const QString& file) {
  choose(m_type, "." + QFileInfo(file).suffix().toLower());
}

bool ExportDialog::canExport() const {
  return m_export->isEnabled();
}

ExportOffer::Stretch ExportDialog::stretch() const {
  const QString take = m_source->currentData().toString();
  for (const ExportOffer::Stretch& one : m_offer.library_takes)
    if (one.name == take) return one;
  return m_offer.session.value_or(ExportOffer::Stretch{});
}

void ExportDialog::sourceChanged() {
  if (m_filling) return;
  m_filling = true;
  const QVariant last = m_part->currentData();
  m_part->clear();
  m_part->addItem(range_words("All", stretch().range), "all");
  const QString source = m_source->currentData().toString();
  const bool of_session = source.isEmpty();
  m_takeTimes = of_session ? std::vector<double>() : m_offer.times_of_take(source);
  if (of_session && m_offer.range) m_part->addItem(range_words("In to out", *m_offer.range), "range");
  if (of_session)
    for (const ExportOffer::Stretch& take : m_offer.takes)
      m_part->addItem(range_words("Take " + take.name, take.range), "take " + take.name);
  if (of_session && m_offer.cursor_s)
    m_part->addItem("The frame shown now: " + in_seconds(*m_offer.cursor_s), "frame");
  choose(m_part, last);
  m_filling = false;
  settle();
}

bool ExportDialog::isPerformed() const {
  return what() == Motion && !m_character->file().isEmpty();
}

/// The file has the unit and axes that are chosen.
bool ExportDialog::hasSpace() const {
  return what() == Motion && !isPerformed() && m_type->currentData().toString() != ".glb";
}

/// Only a table of labels leaves open which tiers it holds; other types hold all.
bool ExportDialog::hasTiers() const {
  return what() == Labels && m_type->currentData().toString() == ".csv";
}

/// Of labels only a label file counts frames.
bool ExportDialog::hasRate() const {
  const bool is_counted = what() != Labels || (hasTiers() && !m_tiers->currentData().toBool());
  return what() != Plots && what() != Trace && m_part->currentData().toString() != "frame" && is_counted;
}

void ExportDialog::setFolder(const QString& folder) {
  m_character->setFolder(folder);
}

QCheckBox* ExportDialog::boxOf(SessionBody body) const {
  return body == SessionBody::User ? m_user : body == SessionBody::Active ? m_active : m_passive;
}

/// @param names  none: the partner alone, which every program can read from a file
void ExportDialog::chooseBodies(const QStringList& names) {
  for (QCheckBox* body : {m_active, m_passive, m_user})
    body->setChecked(names.isEmpty() ? body == boxOf(m_offer.partner) : names.contains(body->text()));
}

/// The character file of the chosen bodies in the scene, the partner's before the other's.
QString ExportDialog::worn() const {
  const SessionBody other =
      m_offer.partner == SessionBody::Active ? SessionBody::Passive : SessionBody::Active;
  for (const SessionBody body : {m_offer.partner, other})
    if (const QString& file = m_offer.worn[body == SessionBody::Active ? 0 : 1];
        boxOf(body)->isChecked() && !file.isEmpty())
      return file;
  return {};
}

void ExportDialog::proposeCharacter() {
  const QString type = m_type->currentData().toString();
  if (m_filling || !m_mayProposeCharacter || what() != Motion || (type != ".glb" && type != ".vrm")) return;
  m_character->setFile(worn());
}

/// A character is written as what it is.
void ExportDialog::showTypes() {
  const QVariant type = m_type->currentData();
  m_filling = true;
  m_type->clear();
  if (what() == Plots) {
    for (const char* ending : {".csv", ".png", ".svg"}) m_type->addItem(export_type_words(ending), ending);
  } else if (isPerformed()) {
    for (const char* ending : {".glb", ".vrm"}) m_type->addItem(character_type_words(ending), ending);
  } else {
    auto endings = export_types(static_cast<ExportContent>(what()));
    if (what() == Motion) endings = {".glb", ".bvh", ".csv", ".npz", ".npy"};  // what most people want first
    for (const std::string& ending : endings)
      m_type->addItem(export_type_words(QString::fromStdString(ending)), QString::fromStdString(ending));
  }
  choose(m_type, type);
  m_filling = false;
  settle();
}

Playback::Range ExportDialog::part() const {
  const QString chosen = m_part->currentData().toString();
  if (chosen == "range" && m_offer.range) return *m_offer.range;
  if (chosen == "frame" && m_offer.cursor_s) return {*m_offer.cursor_s, *m_offer.cursor_s};
  for (const ExportOffer::Stretch& take : m_offer.takes)
    if (chosen == "take " + take.name) return take.range;
  return stretch().range;
}

/// Of the frames in the chosen part.
std::span<const double> ExportDialog::times() const {
  const bool of_session = m_source->currentData().toString().isEmpty();
  const std::vector<double>& all = of_session ? m_offer.times_s : m_takeTimes;
  const auto [from_s, to_s] = part();
  return {std::ranges::lower_bound(all, from_s), std::ranges::upper_bound(all, to_s)};
}

/// All of a session is what there was when it was offered: a live one goes on.
ExportRequest ExportDialog::request() const {
  ExportRequest request;
  request.library_take = m_source->currentData().toString();
  request.plots = what() == Plots;
  ExportWish& wish = request.wish;
  wish.output = m_type->currentData().toString().toStdString();
  if (request.plots) return request;
  wish.content = static_cast<ExportContent>(what());
  if (what() == Motion)
    for (const auto& [box, body] : {std::pair{m_active, SessionBody::Active},
                                    {m_passive, SessionBody::Passive},
                                    {m_user, SessionBody::User}})
      if (box->isChecked()) wish.bodies.push_back(body);
  if (m_part->currentData().toString() == "frame")
    wish.at_s = m_offer.cursor_s;
  else if (m_part->currentData().toString() != "all" || what() == Mesh || request.library_take.isEmpty())
    wish.part = {{}, part().from_s, part().to_s};
  wish.all_tiers = hasTiers() && m_tiers->currentData().toBool();
  if (hasRate()) wish.rate_hz = m_rate->value();
  if (isPerformed()) wish.character = m_character->file().toStdString();
  if (hasSpace())
    wish.space = {m_unit->currentData().toDouble(), m_up->currentData().toBool() ? UpAxis::Z : UpAxis::Y};
  return request;
}

void ExportDialog::showRow(QWidget* field, bool on) {
  field->setVisible(on);
  if (QWidget* label = m_form->labelForField(field)) label->setVisible(on);
}

/// Why the export cannot be started, as far as it can be seen without reading a file; empty = it can.
QString ExportDialog::trouble(const ExportRequest& request) const {
  if (request.plots) return {};
  if (what() == Trace && !request.library_take.isEmpty())
    return "a take of the library was not solved, so it has no trace; choose the session";
  if (m_part->currentData().toString() == "frame" && what() != Mesh)
    return "only a mesh can be exported for a single frame; choose a longer part";
  if (m_source->count() == 0) return "there is nothing to export yet";
  if (isPerformed() && !m_character->trouble().isEmpty()) return m_character->trouble();
  const Status fits = check_export(request.wish);
  return fits ? QString() : QString::fromStdString(fits.error().message);
}

/// Shows what can be chosen now, and what would come of it.
void ExportDialog::settle() {
  if (m_filling) return;
  const What kind = what();
  showRow(m_bodies, kind == Motion);
  showRow(m_character, kind == Motion);
  showRow(m_part, kind != Plots);
  showRow(m_source, kind != Plots);
  showRow(m_tiers, hasTiers());
  showRow(m_rate, hasRate());
  showRow(m_unit, hasSpace());
  showRow(m_up, hasSpace());
  ExportRequest chosen = request();
  chosen.wish.output = "NAME" + chosen.wish.output;
  const auto plan = plan_export(chosen.wish, times());
  QString why_not = trouble(chosen);
  if (why_not.isEmpty() && !chosen.plots && !plan) why_not = QString::fromStdString(plan.error().message);
  const QString about = why_not.isEmpty() && !chosen.plots ? export_content_words(chosen.wish)
                                                           : why_not.left(1).toUpper() + why_not.mid(1);
  m_about->setText(about);
  m_about->setVisible(!about.isEmpty());
  m_export->setEnabled(why_not.isEmpty());
  m_estimate->setText(chosen.plots ? "The panes of the panel Plots"
                      : plan       ? export_plan_words(chosen.wish, *plan)
                                   : "");
}

QStringList ExportDialog::choices() const {
  QStringList bodies;
  for (const QCheckBox* body : {m_active, m_passive, m_user})
    if (body->isChecked()) bodies << body->text();
  if (bodies == QStringList(boxOf(m_offer.partner)->text())) bodies.clear();
  const QString character = m_character->file();
  return {m_what->currentData().toString(), m_type->currentData().toString(),
          m_part->currentData().toString(), bodies.join('+'),
          QString::number(m_rate->value()), m_unit->currentData().toString(),
          m_up->currentData().toString(),   character == worn() ? QString() : character,
          m_tiers->currentData().toString()};
}

void ExportDialog::restore(const QStringList& choices) {
  const bool is_complete = choices.size() == 9;
  chooseBodies(is_complete ? choices[3].split('+', Qt::SkipEmptyParts) : QStringList());
  m_character->setFile(is_complete && worn().isEmpty() ? choices[7] : QString());  // the types depend on it
  if (is_complete) {
    choose(m_what, choices[0].toInt());
    choose(m_type, choices[1]);
    choose(m_part, choices[2]);
    m_rate->setValue(choices[4].toDouble());
    choose(m_unit, choices[5].toDouble());
    choose(m_up, choices[6] == "true");
    choose(m_tiers, choices[8] == "true");
  }
  choose(m_part, "range");
  m_mayProposeCharacter = m_character->file().isEmpty();
  proposeCharacter();
}

}  // namespace abrazo::app
