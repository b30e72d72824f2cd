#include "widgets/library/take_list.hpp"

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>

#include "widgets/common/icons.hpp"
#include "widgets/common/parts.hpp"
#include "widgets/library/take_delegate.hpp"
#include "widgets/library/take_model.hpp"
#include "widgets/library/take_view.hpp"

namespace abrazo::widgets {
namespace {

constexpr int play_interval_ms = 15;
constexpr const char* no_library =
    "No library. Open one (Ctrl+O), build one of motion files, or drop files here.";

constexpr int few_takes = 6;  // are found without a field

/// The panel keeps its width, and the scene beside it too, when the button changes its word.
void keep_room_for(QToolButton& button, const QString& other) {
  const QString word = button.text();
  const int width = button.sizeHint().width();
  button.setText(other);
  button.setMinimumWidth(std::max(width, button.sizeHint().width()));
  button.setText(word);
}

QToolButton* button(QWidget* parent, const QString& text, const QString& name, const QString& tip) {
  auto* button = new QToolButton(parent);
  button->setObjectName("chip");
  button->setText(text);
  describe(*button, name, tip);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return button;
}

}  // namespace

TakeList::TakeList(QWidget* parent)
    : QWidget(parent),
      m_model(new TakeModel(this)),
      m_filter(new TakeFilter(m_model, this)),
      m_view(new TakeView(*m_model, *m_filter, this)),
      m_delegate(new TakeDelegate(*m_model, *m_filter, this)),
      m_palette(palette_of(Theme::Dark)) {
  setObjectName("panel");
  setAttribute(Qt::WA_StyledBackground);
  m_view->setItemDelegate(m_delegate);
  m_empty = new QLabel(no_library, this);
  m_empty->setWordWrap(true);
  m_empty->setContentsMargins(12, 10, 12, 10);
  auto* column = column_in(this, {}, 0);
  column->addWidget(makeHead());
  column->addWidget(m_empty);
  column->addWidget(m_view, 1);
  column->addWidget(makeFoot());
  m_playing.setInterval(play_interval_ms);
  setFocusProxy(m_view);
  leave_by_escape(*m_find, *m_view);
  connectParts();
  showFoot();
}

QWidget* TakeList::makeHead() {
  auto* head = new QWidget(this);
  auto* row = row_in(head, {12, 4, 12, 6}, 6);
  m_find = new QLineEdit(head);
  m_find->setPlaceholderText("Take or move");
  m_find->setClearButtonEnabled(true);
  m_find->setAccessibleName("Find takes by name or move");
  m_order = new QComboBox(head);
  m_order->addItems({"In order", "Name", "Longest", "Most moves", "Most used"});
  describe(*m_order, "Order of the takes",
           "Order of the takes. Most used: by how often this session selected from them, as counted when "
           "it is chosen");
  m_order->setMinimumContentsLength(6);
  m_order->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  row->addWidget(m_find, 3);
  row->addWidget(m_order, 2);
  return head;
}

QWidget* TakeList::makeFoot() {
  auto* foot = new QWidget(this);
  auto* column = column_in(foot, {12, 6, 12, 8}, 6);
  m_coverage = new QLabel(foot);
  m_coverage->setAccessibleName("Coverage");
  auto* buttons = nested_row({}, 6);
  m_play = button(foot, "Play", "Play the take as recorded",
                  "Plays the recorded pair in the scene, from the mark in the strip on");
  m_dance = button(
      foot, "Dance", "Dance with this take",
      "Its active performer plays the user; the take is then not selected from (Return, double click)");
  m_veto = button(foot, "Exclude", "Exclude the take from selection", "No pair of the take is selected");
  keep_room_for(*m_play, "Stop");
  keep_room_for(*m_veto, "Use again");
  m_coverage->setMinimumWidth(1);  // of the buttons
  for (QToolButton* one : {m_play, m_dance, m_veto}) buttons->addWidget(one);
  column->addWidget(m_coverage);
  column->addLayout(buttons);
  return foot;
}

void TakeList::connectParts() {
  connect(m_find, &QLineEdit::textChanged, this, [this](const QString& text) {
    m_filter->setWanted(text);
    showFoot();
  });
  connect(m_find, &QLineEdit::returnPressed, this, [this] {
    if (m_view->currentTake() < 0) m_view->setCurrentIndex(m_filter->index(0, 0));
    m_view->setFocus(Qt::TabFocusReason);
  });
  connect(m_order, qOverload<int>(&QComboBox::currentIndexChanged), this,
          [this](int order) { m_filter->setOrder(static_cast<TakeOrder>(order)); });
  connect(m_view, &TakeView::lookedAt, this, &TakeList::look);
  connect(m_view, &TakeView::lookedAway, this, &TakeList::lookAway);
  connect(m_view, &TakeView::activatedTake, this, &TakeList::danceRequested);
  connect(m_view, &TakeView::currentTakeChanged, this, [this] { showFoot(); });
  connect(m_view, &TakeView::menuRequested, this, &TakeList::showMenu);
  connect(m_play, &QToolButton::clicked, this, &TakeList::togglePlay);
  connect(m_dance, &QToolButton::clicked, this, &TakeList::dance);
  connect(m_veto, &QToolButton::clicked, this, &TakeList::toggleVeto);
  connect(&m_playing, &QTimer::timeout, this, &TakeList::playOn);
}

void TakeList::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  stop();
  const int selected = library && library == m_model->library() ? m_view->currentTake() : -1;
  if (library != m_model->library()) m_typical_m.reset();
  m_model->setLibrary(std::move(library));
  if (selected >= 0) m_view->setCurrentTake(selected);
  showFoot();
}

void TakeList::setColours(const Palette& palette) {
  m_palette = palette;
  m_delegate->setColours(palette);
  m_model->setColours(palette);
  showFoot();
}

int TakeList::selectedTake() const {
  return m_view->currentTake();
}

int TakeList::wanted() const {
  return m_view->currentTake() >= 0 ? m_view->currentTake() : m_model->sourceTake();
}

void TakeList::setSource(int take, int frame) {
  m_model->setSource(take, frame);
}

void TakeList::setSelectedTake(int take) {
  if (take >= 0 && !m_filter->indexOf(take).isValid()) m_find->clear();
  m_view->setCurrentTake(take);
}

void TakeList::showPlace(int take, int frame) {
  setSelectedTake(take);
  m_model->setCursor(take, frame);
}

void TakeList::setVetoedTakes(const std::set<std::string>& takes) {
  m_model->setVetoed(takes);
  showFoot();
}

void TakeList::setUsersTake(const std::string& take) {
  m_model->setUsersTake(take);
  showFoot();
}

void TakeList::setBelief(const FrameIntent& intent) {
  m_model->setBelief(intent);
}

void TakeList::showOtherFrames() {
  m_model->beginCoverage();
}

void TakeList::refresh(const FrameHistory& history) {
  if (!m_model->coverage().append_new(history)) return;
  m_model->coverageChanged();
  m_coverage->setText(coverageText());
}

void TakeList::setTypicalDistance(std::optional<double> distance_m) {
  m_typical_m = distance_m;
  showFoot();
}

QString TakeList::coverageText() const {
  const TakeCoverage& coverage = m_model->coverage();
  const auto share = m_typical_m ? coverage.share_within(*m_typical_m) : std::nullopt;
  if (!share) return m_typical_m ? "Coverage: no frames yet" : "Coverage: being measured";
  return QString("Coverage %1%2 % of %3 frames")
      .arg(coverage.is_estimated() ? "\u2248 " : "")
      .arg(100 * *share, 0, 'f', 0)
      .arg(coverage.user_frames());
}

void TakeList::look(int take, int frame) {
  m_playing.stop();
  m_model->setCursor(take, frame);
  m_shownPair = m_model->pairs().pair_at(take, frame);
  emit recordedShown(m_shownPair, false);
  showFoot();
}

void TakeList::lookAway() {
  if (isPlaying() || m_shownPair < 0) return;
  m_shownPair = -1;
  m_model->setCursor(-1, 0);
  emit recordedShown(-1, false);
}

void TakeList::togglePlay() {
  if (isPlaying()) return stop();
  const int take = wanted();
  if (take < 0) return;
  const TakeRow& row = m_model->row(take);
  const bool at_mark = m_model->cursorTake() == take && m_model->cursorFrame() + 1 < row.frames;
  m_playedTake = take;
  m_playedFrom = at_mark ? m_model->cursorFrame() : 0;
  m_shownPair = -1;
  m_sinceStart.start();
  m_playing.start();
  playOn();
  showFoot();
}

/// The frame that is due, at the take's own rate.
void TakeList::playOn() {
  const TakeRow& row = m_model->row(m_playedTake);
  const int frame =
      m_playedFrom + static_cast<int>(static_cast<double>(m_sinceStart.elapsed()) / 1000 * row.fps);
  if (frame >= row.frames) return stop();
  m_model->setCursor(m_playedTake, frame);
  const int pair = m_model->pairs().pair_at(m_playedTake, frame);
  if (pair == m_shownPair) return;
  emit recordedShown(pair, m_shownPair >= 0);
  m_shownPair = pair;
}

void TakeList::stop() {
  const bool shows = isPlaying() || m_shownPair >= 0;
  m_playing.stop();
  m_shownPair = -1;
  if (shows) {
    m_model->setCursor(-1, 0);
    emit recordedShown(-1, false);
  }
  showFoot();
}

void TakeList::dance() {
  if (wanted() >= 0) emit danceRequested(wanted());
}

void TakeList::toggleVeto() {
  if (wanted() >= 0) emit vetoRequested(wanted());
}

void TakeList::goToSource() {
  if (m_model->sourceTake() >= 0) showPlace(m_model->sourceTake(), m_model->sourceFrame());
  m_view->setFocus(Qt::TabFocusReason);
}

void TakeList::find() {
  m_find->show();
  m_find->setFocus(Qt::TabFocusReason);
  m_find->selectAll();
}

void TakeList::showFoot() {
  const bool any = m_model->rowCount() > 0;
  m_empty->setVisible(!any || m_filter->rowCount() == 0);
  m_empty->setText(any ? "No take has “" + m_find->text() + "” in its name or moves." : no_library);
  const bool are_many = m_model->rowCount() > few_takes;
  m_order->setVisible(are_many);
  m_find->setVisible(are_many || m_find->hasFocus() || !m_find->text().isEmpty());
  const int take = any ? wanted() : -1;
  for (QToolButton* one : {m_play, m_dance, m_veto}) one->setEnabled(take >= 0);
  m_play->setText(isPlaying() ? "Stop" : "Play");
  m_play->setIcon(icon(isPlaying() ? Icon::Pause : Icon::Play, m_palette.text));
  const bool vetoed = take >= 0 && m_model->isVetoed(take);
  m_veto->setText(vetoed ? "Use again" : "Exclude");
  m_dance->setEnabled(take >= 0 && !m_model->isUsers(take));
  m_coverage->setText(any ? coverageText() : QString());
  m_coverage->setVisible(any);
  m_coverage->setToolTip(
      QString(
          "The share of the user's frames whose nearest recorded pair is closer in feature space than %1: "
          "the library's own typical neighbour distance, the median distance of its pairs to the nearest "
          "that is not within a second of them in the same take.\n"
          "In a row: the bars below the moves show which parts of a take this session selected, the figure "
          "how often. The light below the bars is belief, with the selection “intent”: where the user's "
          "last two seconds say that the partner comes from next; full light is the likeliest place of the "
          "library.")
          .arg(m_typical_m ? QString::number(*m_typical_m, 'f', 3) + " m" : "the typical distance"));
}

void TakeList::showMenu(int take, const QPoint& at) {
  QMenu menu(this);
  menu.addAction(isPlaying() ? "Stop" : "Play as recorded", this, &TakeList::togglePlay);
  menu.addAction("Dance with this take", this, &TakeList::dance)->setEnabled(!m_model->isUsers(take));
  menu.addAction(m_model->isVetoed(take) ? "Use again" : "Exclude from selection", this,
                 &TakeList::toggleVeto);
  menu.addAction("Annotate take", this, [this, take] { emit annotateRequested(take); });
  for (const bool second : {false, true})
    menu.addAction(QString("Import options of performer %1…").arg(second ? "B" : "A"), this,
                   [this, take, second] { emit readingRequested(take, second); });
  menu.addSeparator();
  menu.addAction("Go to the shown source", this, &TakeList::goToSource);
  menu.exec(at);
}

}  // namespace abrazo::widgets
