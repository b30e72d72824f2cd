#include "app/workbench/library/retarget_dialog.hpp"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <algorithm>

#include "app/workbench/base/character_field.hpp"
#include "app/workbench/base/choose_button.hpp"
#include "app/workbench/base/error_words.hpp"
#include "app/workbench/library/body_field.hpp"
#include "app/workbench/library/factor_field.hpp"
#include "app/workbench/library/retarget_preview.hpp"
#include "widgets/common/file_dialog.hpp"

namespace abrazo::app {
namespace {

constexpr int highest_frame = 100'000'000;

QLabel* caption(const QString& name, QWidget* field) {
  auto* label = new QLabel(name);
  label->setObjectName("secondary");
  label->setBuddy(field);
  field->setAccessibleName(name);
  return label;
}

QSpinBox* frame_box(const QString& special, QWidget* parent) {
  auto* box = new QSpinBox(parent);
  box->setRange(-1, highest_frame);
  box->setSpecialValueText(special);
  box->setValue(-1);
  return box;
}

QString take_words(const RetargetOffer::Take& take) {
  if (take.frames == 0) return take.name;
  return QString("%1   %L2 frames, %3 s")
      .arg(take.name)
      .arg(take.frames)
      .arg(take.frames / take.rate_hz, 0, 'f', 1);
}

}  // namespace

RetargetDialog::RetargetDialog(QWidget* parent) : QDialog(parent) {
  setObjectName("retarget");
  setWindowTitle("Retarget takes");
  resize(1160, 640);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(20, 16, 20, 16);
  grid->setHorizontalSpacing(24);
  grid->setVerticalSpacing(10);
  grid->addWidget(makeTakes(), 0, 0);
  grid->addWidget(makeChoices(), 1, 0);
  m_preview = new RetargetPreview(this);
  grid->addWidget(m_preview, 0, 1, 2, 1);
  m_about = new QLabel(this);
  m_about->setObjectName("secondary");
  m_about->setWordWrap(true);
  grid->addWidget(m_about, 2, 0, 1, 2);
  grid->addWidget(makeFoot(), 3, 0, 1, 2);
  grid->setRowStretch(0, 1);
  grid->setColumnStretch(0, 2);
  grid->setColumnStretch(1, 3);
  showTypes();
}

QWidget* RetargetDialog::makeTakes() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  m_source = new QComboBox(box);
  m_source->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto* manifest = choose_button("Takes of a manifest", box);
  manifest->setToolTip("Takes of a manifest (.json) that is not open");
  m_takes = new QListWidget(box);
  m_takes->setSelectionMode(QAbstractItemView::ExtendedSelection);
  m_takes->setAccessibleName("Takes");
  // Without a border Qt pads selected items only.
  m_takes->setStyleSheet("QListWidget::item { padding: 3px 6px; border: 1px solid transparent; }");
  grid->addWidget(caption("Takes of", m_source), 0, 0);
  grid->addWidget(m_source, 0, 1);
  grid->addWidget(manifest, 0, 2);
  grid->addWidget(m_takes, 1, 0, 1, 3);
  grid->setColumnStretch(1, 1);
  connect(m_source, qOverload<int>(&QComboBox::currentIndexChanged), this, &RetargetDialog::showTakes);
  connect(m_takes, &QListWidget::itemSelectionChanged, this, &RetargetDialog::settle);
  connect(m_takes, &QListWidget::currentItemChanged, this, &RetargetDialog::settle);
  connect(manifest, &QToolButton::clicked, this, [this] {
    const QString file = widgets::choose_file(this, "Takes of a manifest", folder(), "Manifests (*.json)");
    if (!file.isEmpty()) emit manifestChosen(file);
  });
  return box;
}

void RetargetDialog::addBody(QGridLayout* grid, int row, const QString& name, BodyField*& field) {
  field = new BodyField(name, this);
  auto* label = caption(name, field);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  label->setContentsMargins(0, 6, 0, 0);  // beside the text, not the slider
  grid->addWidget(label, row, 0);
  grid->addWidget(field, row, 1, 1, 2);
  connect(field, &BodyField::changed, this, &RetargetDialog::settle);
}

void RetargetDialog::addFactor(QGridLayout* grid, int row, const QString& name, const QString& tip,
                               FactorField*& field) {
  field = new FactorField(name, RetargetWish::greatest_factor, this);
  field->setToolTip(tip);
  grid->addWidget(caption(name, field), row, 0);
  grid->addWidget(field, row, 1, 1, 2);
  connect(field, &FactorField::changed, this, &RetargetDialog::settle);
}

QLineEdit* RetargetDialog::addFile(QGridLayout* grid, int row, const QString& name,
                                   const QString& placeholder) {
  auto* field = new QLineEdit(this);
  field->setPlaceholderText(placeholder);
  grid->addWidget(caption(name, field), row, 0);
  grid->addWidget(field, row, 1);
  connect(field, &QLineEdit::textChanged, this, &RetargetDialog::settle);
  return field;
}

QWidget* RetargetDialog::makeChoices() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(8);
  m_from = frame_box("first", box);
  m_to = frame_box("all", box);
  m_to->setToolTip("The frame behind the last");
  auto* frames = new QHBoxLayout;
  frames->setSpacing(8);
  frames->addWidget(m_from, 1);
  frames->addWidget(caption("up to", m_to));
  frames->addWidget(m_to, 1);
  grid->addWidget(caption("From frame", m_from), 0, 0);
  grid->addLayout(frames, 0, 1);
  m_to->setAccessibleName("To frame");
  addBody(grid, 1, "Leader's body", m_leader);
  addBody(grid, 2, "Follower's body", m_follower);
  addFactor(
      grid, 3, "Contacts",
      "Weight of the recorded distances of near joints: more keeps contacts, less the shape of each body. "
      "A double click returns to 1",
      m_contacts);
  addFactor(grid, 4, "Smoothness",
            "Weight of the smoothed motion: less follows each frame alone. A double click returns to 1",
            m_smoothness);
  m_character = new CharacterField(box);
  grid->addWidget(caption("Character", m_character), 5, 0);
  grid->addWidget(m_character, 5, 1, 1, 2);
  m_folder = addFile(grid, 6, "Folder", "of the files");
  auto* choose_folder = choose_button("Folder", box);
  grid->addWidget(choose_folder, 6, 2);
  m_name = addFile(grid, 7, "Name", "of the file; several takes append theirs");
  m_name->setText("retargeted");
  m_type = new QComboBox(box);
  grid->addWidget(caption("As", m_type), 8, 0);
  grid->addWidget(m_type, 8, 1);
  m_trace = new QCheckBox("Trace of every frame (.jsonl), for “abrazo render”", box);
  grid->addWidget(m_trace, 9, 1);
  grid->setRowStretch(10, 1);
  grid->setColumnStretch(1, 1);
  for (QSpinBox* frame : {m_from, m_to})
    connect(frame, qOverload<int>(&QSpinBox::valueChanged), this, &RetargetDialog::settle);
  connect(m_character, &CharacterField::changed, this, &RetargetDialog::showTypes);
  connect(m_type, qOverload<int>(&QComboBox::currentIndexChanged), this, &RetargetDialog::settle);
  connect(m_trace, &QCheckBox::toggled, this, &RetargetDialog::settle);
  connect(m_folder, &QLineEdit::textChanged, m_character, &CharacterField::setFolder);
  for (BodyField* body : {m_leader, m_follower})
    connect(m_folder, &QLineEdit::textChanged, body, &BodyField::setFolder);
  connect(choose_folder, &QToolButton::clicked, this, [this] {
    const QString chosen = widgets::choose_folder(this, "Folder of the files", folder());
    if (!chosen.isEmpty()) setFolder(chosen);
  });
  return box;
}

QWidget* RetargetDialog::makeFoot() {
  auto* foot = new QWidget(this);
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(0, 0, 0, 0);
  m_state = new QLabel(foot);
  m_state->setObjectName("state");
  m_state->setWordWrap(true);
  m_state->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_progress = new QProgressBar(foot);
  m_progress->setRange(0, 1000);
  m_progress->setFixedWidth(160);
  m_progress->setTextVisible(false);
  m_progress->setAccessibleName("Progress");
  m_progress->hide();
  m_cancel = new QPushButton("Close", foot);
  m_start = new QPushButton("Retarget", foot);
  m_start->setDefault(true);
  row->addWidget(m_state, 1);
  row->addWidget(m_progress);
  row->addWidget(m_cancel);
  row->addWidget(m_start);
  connect(m_cancel, &QPushButton::clicked, this, &RetargetDialog::reject);
  connect(m_start, &QPushButton::clicked, this, &RetargetDialog::retargetRequested);
  return foot;
}

void RetargetDialog::offer(const RetargetOffer& offer) {
  const auto same = std::ranges::find(m_offers, offer.manifest, &RetargetOffer::manifest);
  const auto index = static_cast<int>(same - m_offers.begin());
  m_filling = true;
  if (same == m_offers.end()) {
    m_offers.push_back(offer);
    m_source->addItem(offer.name);
  } else {
    *same = offer;
    m_source->setItemText(index, offer.name);
  }
  m_source->setCurrentIndex(index);
  m_filling = false;
  showTakes();
}

const RetargetOffer* RetargetDialog::source() const {
  const int index = m_source->currentIndex();
  return index < 0 ? nullptr : &m_offers[static_cast<std::size_t>(index)];
}

QString RetargetDialog::manifest() const {
  return source() ? source()->manifest : QString();
}

void RetargetDialog::showTakes() {
  if (m_filling) return;
  QStringList chosen;
  for (const QListWidgetItem* item : m_takes->selectedItems()) chosen << item->data(Qt::UserRole).toString();
  m_filling = true;
  m_takes->clear();
  if (source())
    for (const RetargetOffer::Take& take : source()->takes) {
      auto* item = new QListWidgetItem(take_words(take), m_takes);
      item->setData(Qt::UserRole, take.name);
    }
  m_filling = false;
  chooseTakes(chosen);
}

void RetargetDialog::chooseTakes(const QStringList& names) {
  m_filling = true;
  for (int row = 0; row < m_takes->count(); ++row) {
    QListWidgetItem* item = m_takes->item(row);
    item->setSelected(names.contains(item->data(Qt::UserRole).toString()));
  }
  m_filling = false;
  settle();
}

/// A character is written as what it is; motion as every type that holds two bodies.
void RetargetDialog::showTypes() {
  const QString chosen = m_type->currentData().toString();
  m_filling = true;
  m_type->clear();
  if (m_character->file().isEmpty()) {
    m_type->addItem("BVH (.bvh): two skeletons", ".bvh");
    m_type->addItem("glTF binary (.glb): two skinned bodies", ".glb");
    m_type->addItem("Table (.csv)", ".csv");
    m_type->addItem("NumPy (.npz)", ".npz");
  } else {
    m_type->addItem("glTF binary (.glb): a file for each of the two", ".glb");
    m_type->addItem("VRM (.vrm): a file for each of the two", ".vrm");
  }
  m_type->setCurrentIndex(std::max(0, m_type->findData(chosen)));
  m_filling = false;
  settle();
}

QString RetargetDialog::folder() const {
  return m_folder->text().trimmed();
}

void RetargetDialog::setFolder(const QString& folder) {
  m_folder->setText(folder);
}

void RetargetDialog::setColours(const widgets::Palette& palette) {
  for (BodyField* body : {m_leader, m_follower}) body->setColours(palette);
  for (FactorField* factor : {m_contacts, m_smoothness}) factor->setColours(palette);
  m_preview->setColours(palette);
}

/// Takes, frames and bodies, without files.
Result<RetargetWish> RetargetDialog::pairs() const {
  RetargetWish wish;
  for (int row = 0; row < m_takes->count(); ++row)
    if (m_takes->item(row)->isSelected())
      wish.takes.push_back(m_takes->item(row)->data(Qt::UserRole).toString().toStdString());
  wish.from = std::max(0, m_from->value());
  if (m_to->value() >= 0) wish.to = m_to->value();
  for (const auto& [box, body] : {std::pair{m_leader, &wish.active}, {m_follower, &wish.passive}}) {
    auto choice = parse_body_choice(box->text().toStdString());
    if (!choice) return choice.error();
    *body = std::move(*choice);
  }
  wish.contacts = m_contacts->factor();
  wish.smoothness = m_smoothness->factor();
  return wish;
}

Result<RetargetWish> RetargetDialog::previewed() const {
  auto wish = pairs();
  if (!wish) return wish;
  if (wish->takes.empty()) return Error{"choose a take to see it here", ""};
  const QListWidgetItem* current = m_takes->currentItem();
  const bool is_chosen = current && current->isSelected();
  wish->takes = {is_chosen ? current->data(Qt::UserRole).toString().toStdString() : wish->takes.front()};
  return wish;
}

Result<RetargetWish> RetargetDialog::wish() const {
  auto chosen = pairs();
  if (!chosen) return chosen;
  RetargetWish& wish = *chosen;
  wish.character = m_character->file().toStdString();
  const QString name = m_name->text().trimmed();
  if (name.isEmpty()) return Error{"the file has no name yet; give one", ""};
  if (folder().isEmpty()) return Error{"the files have no folder yet; choose one", ""};
  const QString path = QDir(folder()).filePath(name);
  wish.output = (path + m_type->currentData().toString()).toStdString();
  if (m_trace->isChecked()) wish.trace = (path + ".jsonl").toStdString();
  return chosen;
}

/// Why the choices cannot be fulfilled, as far as it can be seen without reading a take; empty = they can.
QString RetargetDialog::trouble() const {
  const auto chosen = wish();
  if (!chosen) return words(chosen.error());
  if (const QString none = m_character->trouble(); !none.isEmpty()) return none;
  if (const Status usable = check_retargeting(*chosen, manifest().toStdString()); !usable)
    return words(usable.error());
  for (const RetargetOffer::Take& take : source()->takes) {
    if (take.frames == 0 || std::ranges::count(chosen->takes, take.name.toStdString()) == 0) continue;
    const auto last = chosen->to.value_or(take.frames);
    if (last > take.frames || chosen->from >= last)
      return QString("%1 has frames 0 to %L2").arg(take.name).arg(take.frames);
  }
  return {};
}

/// The files, and those that are replaced.
QString RetargetDialog::outcome(const RetargetWish& wish) const {
  QStringList files, replaced;
  for (const std::string& take : wish.takes) {
    std::vector<std::string> of_take = wish.motion_files(take);
    if (!wish.trace.empty()) of_take.push_back(wish.trace_file(take));
    for (const std::string& file : of_take) {
      const QFileInfo info(QString::fromStdString(file));
      files << info.fileName();
      if (info.exists()) replaced << info.fileName();
    }
  }
  constexpr int most_named = 3;
  const auto named = [](const QStringList& names) {
    return names.size() <= most_named ? names.join(", ")
                                      : QString("%1, … (%2 files)")
                                            .arg(QStringList(names.mid(0, most_named)).join(", "))
                                            .arg(names.size());
  };
  QString text = "Writes " + named(files);
  if (!replaced.isEmpty()) text += ". Replaces " + named(replaced);
  return text;
}

void RetargetDialog::settle() {
  if (m_filling) return;
  const QString why_not = trouble();
  m_about->setText(why_not.isEmpty() ? outcome(*wish()) : why_not.left(1).toUpper() + why_not.mid(1));
  m_start->setEnabled(!m_busy && why_not.isEmpty());
  emit choiceChanged();
}

void RetargetDialog::showProgress(const QString& doing, double fraction) {
  m_busy = true;
  m_progress->show();
  m_progress->setValue(static_cast<int>(1000 * fraction));
  m_state->setText(doing);
  m_cancel->setText("Cancel");
  m_start->setEnabled(false);
}

void RetargetDialog::endProgress(const QString& text) {
  m_busy = false;
  m_progress->hide();
  m_state->setText(text);
  m_cancel->setText("Close");
  settle();
}

void RetargetDialog::reject() {
  if (m_busy) return emit cancelRequested();
  QDialog::reject();
}

}  // namespace abrazo::app
