// Each key of the keymap, pressed in the whole window on the generated dance, by what it does. Keys of
// labels: annotation_actions_test.
#include <ostream>

#include "app/workbench/solve/intended_move_desk.hpp"
#include "app/workbench/takes/take_desk.hpp"
#include "tests/workbench/key_window.hpp"
#include "widgets/intended/intended_move_popup.hpp"

namespace abrazo::app::keys_test {
namespace {

/// What was the case when the key was pressed.
struct Before {
  double cursor_s = 0, speed = 1;
  std::uint64_t index = 0;
  widgets::OrbitCamera camera;
  widgets::PartVisibility parts{};
  int morph = 0;
  double cut_azimuth_rad = 0;
};

void nothing() {}

TakeDesk& takes() {
  return *window->findChild<TakeDesk*>();
}
void end_take() {
  if (takes().isRecording()) takes().toggle();
}
/// A take that is kept: one without frames is not, and a busy machine may not have solved one yet.
void record_take() {
  if (!takes().isRecording()) takes().toggle();
  until([] { return window->session()->engine().recorder()->state().take_span.frames > 0; });
  end_take();
}

struct KeyRow {
  const char* name;
  int key;
  Qt::KeyboardModifiers held;
  std::function<void()> prepare;
  std::function<bool(const Before&)> effect;
};

std::ostream& operator<<(std::ostream& out, const KeyRow& row) {
  return out << row.name;
}

constexpr auto shift = Qt::ShiftModifier;
constexpr auto ctrl = Qt::ControlModifier;
constexpr auto alt = Qt::AltModifier;
constexpr auto pad = Qt::KeypadModifier;
constexpr Qt::KeyboardModifiers none = Qt::NoModifier;

bool stepped(const Before& before, int frames) {
  return static_cast<long long>(ticker().shown()->index) - static_cast<long long>(before.index) == frames &&
         playback().state == State::Parked;
}

double turned(const Before& before) {
  return std::remainder(scene().options().cut_azimuth_rad - before.cut_azimuth_rad, 4 * quarter);
}

bool toggled(const Before& before, ScenePart part) {
  return shows(part) != before.parts[static_cast<std::size_t>(part)];
}

/// Answers the next dialog that blocks. What it was is kept.
QString blocked_by;
void dismiss_next_dialog() {
  blocked_by.clear();
  auto* timer = new QTimer(window);
  QObject::connect(timer, &QTimer::timeout, timer, [timer] {
    auto* modal = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!modal) return;
    blocked_by = modal->metaObject()->className();
    timer->deleteLater();
    modal->reject();
  });
  timer->start(20);
}

int sessions_begun = 0;
void count_sessions() {
  sessions_begun = 0;
  QObject::connect(&window->document(), &Document::began, window, [] { ++sessions_begun; });
}

int pictures_in(const QString& folder) {
  return QDir(folder).entryList({"abrazo-*.png"}).size();
}
int pictures_before = 0;
/// Made with the first one: the home folder of the tests is empty.
QString pictures_folder() {
  return QDir::homePath() + "/Pictures";
}
void count_pictures() {
  pictures_before = pictures_in(pictures_folder());
}
QImage newest_picture() {
  const QDir folder(pictures_folder());
  const QStringList files = folder.entryList({"abrazo-*.png"}, QDir::Files, QDir::Name);
  return files.size() > pictures_before ? QImage(folder.filePath(files.back())) : QImage();
}

void change_alpha() {
  window->document().changeSetting("alpha", "0.77");
}
void change_alpha_and_undo() {
  change_alpha();
  window->undoStack().undo();
}
bool alpha_is_changed() {
  return std::abs(window->document().settings().alpha - 0.77) < 1e-12;
}
void freeze() {
  window->findChild<ComparisonDesk*>()->freeze();
  change_alpha();
}
void come_near() {
  select_leader_root();
  scene().frameSelection();
  QTest::qWait(400);
  focus_scene();
}
void cut() {
  widgets::SceneOptions options;
  options.cuts = options.cut_in_world = true;
  scene().setOptions(options);
}
bool input_is_held() {
  return window->session()->engine().is_held();
}

std::vector<KeyRow> transport_rows() {
  return {
      {"Space", Qt::Key_Space, none, nothing, [](auto&) { return playback().state == State::Playing; }},
      {"Left", Qt::Key_Left, none, nothing, [](auto& b) { return stepped(b, -1); }},
      {"Right", Qt::Key_Right, none, nothing, [](auto& b) { return stepped(b, 1); }},
      {"ShiftLeft", Qt::Key_Left, shift, nothing, [](auto& b) { return stepped(b, -10); }},
      {"ShiftRight", Qt::Key_Right, shift, nothing, [](auto& b) { return stepped(b, 10); }},
      {"CtrlLeft", Qt::Key_Left, ctrl, [] { mark(1.45); },
       [](auto&) { return std::abs(playback().cursor_s - 1.45) < 1e-6; }},
      {"CtrlRight", Qt::Key_Right, ctrl, [] { mark(1.55); },
       [](auto&) { return std::abs(playback().cursor_s - 1.55) < 1e-6; }},
      {"Home", Qt::Key_Home, none, nothing, [](auto&) { return playback().cursor_s == playback().first_s; }},
      {"End", Qt::Key_End, none, nothing, [](auto&) { return playback().state == State::Following; }},
      {"J", Qt::Key_J, none, nothing,
       [](auto&) { return playback().state == State::Playing && playback().speed < 0; }},
      {"K", Qt::Key_K, none, [] { ticker().toggle(); },
       [](auto&) { return playback().state == State::Parked; }},
      {"L", Qt::Key_L, none, nothing,
       [](auto&) { return playback().state == State::Playing && playback().speed > 0; }},
      {"I", Qt::Key_I, none, nothing, [](auto&) { return playback().in_set && playback().in_s == 1.5; }},
      {"O", Qt::Key_O, none, nothing, [](auto&) { return playback().out_set && playback().out_s == 1.5; }},
      {"AltI", Qt::Key_I, alt, [] { ticker().setRange(1, 2); }, [](auto&) { return !playback().in_set; }},
      {"AltO", Qt::Key_O, alt, [] { ticker().setRange(1, 2); }, [](auto&) { return !playback().out_set; }},
      {"CtrlL", Qt::Key_L, ctrl, nothing, [](auto&) { return playback().loop; }},
      {"BracketLeft", Qt::Key_BracketLeft, none, nothing, [](auto&) { return playback().speed == 0.5; }},
      {"BracketRight", Qt::Key_BracketRight, none, nothing, [](auto&) { return playback().speed > 1; }},
      {"Backspace", Qt::Key_Backspace, none, [] { ticker().setSpeed(0.25); },
       [](auto&) { return playback().speed == 1; }},
      {"G", Qt::Key_G, none, nothing, [](auto&) { return entry() != nullptr; }},
      {"M", Qt::Key_M, none, nothing, [](auto&) { return markers() == 1; }},
      {"ShiftM", Qt::Key_M, shift, nothing, [](auto&) { return entry() != nullptr && markers() == 0; }},
      {"Del", Qt::Key_Delete, none, [] { mark(1.5); }, [](auto&) { return markers() == 0; }},
      {"Z", Qt::Key_Z, none, [] { window->timeline().zoom(0.3); },
       [](auto&) {
         return window->timeline().axis().span_s >= playback().last_s - playback().first_s - 0.5;
       }},
      {"ShiftZ", Qt::Key_Z, shift, [] { ticker().setRange(1, 1.8); },
       [](auto&) { return window->timeline().axis().span_s < 2; }},
  };
}

std::vector<KeyRow> scene_rows() {
  std::vector<KeyRow> rows = {
      {"F", Qt::Key_F, none, select_leader_root,
       [](auto&) {
         const Vec3 root = ticker().shown()->result.result.row(0);
         return (camera().target - root).norm() < 1e-6;
       }},
      {"HomeInTheScene", Qt::Key_Home, none, come_near,
       [](auto& b) { return !(camera() == b.camera) && playback().cursor_s == b.cursor_s; }},
      {"Digit1", Qt::Key_1, none, nothing, [](auto&) { return looks_from(0, 0.05); }},
      {"Ctrl1", Qt::Key_1, ctrl, nothing, [](auto&) { return looks_from(2 * quarter, 0.05); }},
      {"Digit3", Qt::Key_3, none, nothing, [](auto&) { return looks_from(quarter, 0.05); }},
      {"Ctrl3", Qt::Key_3, ctrl, nothing, [](auto&) { return looks_from(-quarter, 0.05); }},
      {"Digit7", Qt::Key_7, none, nothing, [](auto&) { return looks_from(0, quarter); }},
      {"Ctrl7", Qt::Key_7, ctrl, nothing, [](auto&) { return looks_from(0, -quarter); }},
      {"Digit9", Qt::Key_9, none, nothing, [](auto&) { return looks_from(quarter / 2, 0.61547971); }},
      {"Ctrl9", Qt::Key_9, ctrl, nothing, [](auto&) { return looks_from(-3 * quarter / 2, 0.61547971); }},
      {"Digit5", Qt::Key_5, none, nothing, [](auto&) { return scene().options().is_parallel; }},
      {"Digit0", Qt::Key_0, none, [] { scene().lookFrom(2.9, 1.2), QTest::qWait(400); },
       [](auto& b) { return !(camera() == b.camera) && camera().elevation_rad < 0.5; }},
      {"Keypad1", Qt::Key_1, pad, nothing, [](auto&) { return looks_from(0, 0.05); }},
      {"Keypad3", Qt::Key_3, pad, nothing, [](auto&) { return looks_from(quarter, 0.05); }},
      {"Keypad7", Qt::Key_7, pad, nothing, [](auto&) { return looks_from(0, quarter); }},
      {"Keypad9", Qt::Key_9, pad, nothing, [](auto&) { return looks_from(quarter / 2, 0.61547971); }},
      {"Keypad5", Qt::Key_5, pad, nothing, [](auto&) { return scene().options().is_parallel; }},
      {"CtrlKeypad1", Qt::Key_1, ctrl | pad, nothing, [](auto&) { return looks_from(2 * quarter, 0.05); }},
      {"AltZ", Qt::Key_Z, alt, [] { scene().lookFrom(1, 0.3), QTest::qWait(400); },
       [](auto& b) { return std::abs(camera().azimuth_rad - b.camera.azimuth_rad) > 1e-3; }},
      {"AltShiftZ", Qt::Key_Z, alt | shift,
       [] {
         scene().lookFrom(1, 0.3), QTest::qWait(400);
         scene().previousView(), QTest::qWait(400);
       },
       [](auto&) { return looks_from(1, 0.3); }},
      {"Backquote", Qt::Key_QuoteLeft, none, select_leader_root,
       [](auto&) { return selection() == Selection::joint(joint_count); }},
      {"X", Qt::Key_X, none, select_leader_root, [](auto&) { return scene().options().isolates; }},
      {"H", Qt::Key_H, none, select_leader_root, [](auto&) { return scene().hidden().size() == 1; }},
      {"AltH", Qt::Key_H, alt, [] { select_leader_root(), scene().hideSelection(); },
       [](auto&) { return scene().hidden().empty(); }},
      {"EscapeInTheScene", Qt::Key_Escape, none, [] { select_leader_root(), focus_scene(); },
       [](auto&) { return !selection() && window->isVisible(); }},
      {"T", Qt::Key_T, none, nothing, [](auto& b) { return toggled(b, ScenePart::Tetrahedra); }},
      {"R", Qt::Key_R, none, nothing, [](auto&) { return scene().options().shows_reference_beside; }},
      {"C", Qt::Key_C, none, nothing, [](auto&) { return scene().options().cuts; }},
      {"ShiftC", Qt::Key_C, shift, nothing,
       [](auto&) { return scene().options().cut_in_world && scene().options().cuts; }},
      {"AltPageUp", Qt::Key_PageUp, alt, cut, [](auto&) { return scene().options().cut_m > 0; }},
      {"AltPageDown", Qt::Key_PageDown, alt, cut, [](auto&) { return scene().options().cut_m < 0; }},
      {"AltLeft", Qt::Key_Left, alt, [] { cut(); }, [](auto& b) { return turned(b) < -0.01; }},
      {"AltRight", Qt::Key_Right, alt, [] { cut(); }, [](auto& b) { return turned(b) > 0.01; }},
      {"AltUp", Qt::Key_Up, alt, cut, [](auto&) { return scene().options().cut_elevation_rad > 0; }},
      {"AltDown", Qt::Key_Down, alt, cut, [](auto&) { return scene().options().cut_elevation_rad < 0; }},
      {"Comma", Qt::Key_Comma, none, nothing, [](auto& b) { return scene().morphStep() == b.morph - 1; }},
      {"Period", Qt::Key_Period, none, [] { scene().stepMorph(-2); },
       [](auto& b) { return scene().morphStep() == b.morph + 1; }},
  };
  static const char* const names[] = {"Alt1", "Alt2", "Alt3", "Alt4", "Alt5", "Alt6", "Alt7", "Alt8", "Alt9"};
  for (int i = 0; i < 9; ++i)
    rows.push_back(
        {names[i], Qt::Key_1 + i, alt, nothing, [](auto& b) { return scene().visibility() != b.parts; }});
  return rows;
}

std::vector<KeyRow> program_rows() {
  return {
      {"CtrlP", Qt::Key_P, ctrl, nothing,
       [](auto&) { return qobject_cast<QLineEdit*>(QApplication::focusWidget()) != nullptr; }},
      {"F3", Qt::Key_F3, none, nothing,
       [](auto&) { return qobject_cast<QLineEdit*>(QApplication::focusWidget()) != nullptr; }},
      {"F1", Qt::Key_F1, none, nothing, [](auto&) { return dialog("Help") != nullptr; }},
      // A keyboard writes it with Shift, which the window system takes out again; a test has none.
      {"Question", Qt::Key_Question, none, nothing, [](auto&) { return dialog("Keys") != nullptr; }},
      {"CtrlZ", Qt::Key_Z, ctrl, change_alpha, [](auto&) { return !alpha_is_changed(); }},
      {"CtrlShiftZ", Qt::Key_Z, ctrl | shift, change_alpha_and_undo,
       [](auto&) { return alpha_is_changed(); }},
      {"CtrlY", Qt::Key_Y, ctrl, change_alpha_and_undo, [](auto&) { return alpha_is_changed(); }},
      {"CtrlO", Qt::Key_O, ctrl, dismiss_next_dialog, [](auto&) { return blocked_by == "QFileDialog"; }},
      {"CtrlS", Qt::Key_S, ctrl, dismiss_next_dialog, [](auto&) { return blocked_by == "QFileDialog"; }},
      {"CtrlShiftS", Qt::Key_S, ctrl | shift, dismiss_next_dialog,
       [](auto&) { return blocked_by == "QFileDialog"; }},
      {"CtrlN", Qt::Key_N, ctrl, count_sessions, [](auto&) { return sessions_begun > 0; }},
      {"CtrlB", Qt::Key_B, ctrl, nothing,
       [](auto&) {
         for (const QDialog* each : window->findChildren<QDialog*>())
           if (each->isVisible() && QString(each->metaObject()->className()).endsWith("BuildDialog"))
             return true;
         return false;
       }},
      {"CtrlF", Qt::Key_F, ctrl, nothing,
       [](auto&) {
         const QWidget* focused = QApplication::focusWidget();
         return qobject_cast<const QLineEdit*>(focused) && window->takes().isAncestorOf(focused);
       }},
      {"AltT", Qt::Key_T, alt, [] { window->takes().setSelectedTake(-1); },
       [](auto&) { return window->takes().selectedTake() >= 0; }},
      {"ShiftSpace", Qt::Key_Space, shift, [] { window->takes().setSelectedTake(0); },
       [](auto&) { return window->takes().isPlaying(); }},
      {"CtrlR", Qt::Key_R, ctrl, end_take, [](auto&) { return takes().isRecording(); }},
      {"CtrlShiftR", Qt::Key_R, ctrl | shift, record_take, [](auto&) { return takes().isRecording(); }},
      {"U", Qt::Key_U, none, [] { ticker().follow(); },  // on an older frame it is tried
       [](auto&) {
         const FrameSnapshotPtr newest = window->session()->latest().newest();
         return newest->settings.user_role == UserRole::Passive;
       }},
      {"W", Qt::Key_W, none, nothing,
       [](auto&) { return window->findChild<IntendedMoveDesk*>()->popup().isVisible(); }},
      {"CtrlSpace", Qt::Key_Space, ctrl, nothing, [](auto&) { return input_is_held(); }},
      {"P", Qt::Key_P, none, nothing, [](auto&) { return window->document().triedPin().has_value(); }},
      {"V", Qt::Key_V, none, nothing, [](auto&) { return !window->document().decisions().vetoes.empty(); }},
      {"ShiftV", Qt::Key_V, shift, nothing,
       [](auto&) { return !window->document().decisions().vetoes.takes.empty(); }},
      {"AltV", Qt::Key_V, alt, nothing,
       [](auto&) { return !window->document().decisions().vetoes.labels.empty(); }},
      {"ShiftP", Qt::Key_P, shift, [] { window->candidates().togglePin(); },
       [](auto&) { return is_neutral(window->document().shownDecisions()); }},
      {"AltC", Qt::Key_C, alt, nothing,
       [](auto&) { return QApplication::focusWidget() == window->candidates().focusProxy(); }},
      {"A", Qt::Key_A, none, nothing,
       [](auto&) { return window->findChild<ComparisonDesk*>()->frozen().has_value(); }},
      {"ShiftA", Qt::Key_A, shift, freeze,
       [](auto&) {
         const auto& frozen = window->findChild<ComparisonDesk*>()->frozen();
         return frozen && frozen->alpha == 0.77 && !alpha_is_changed();
       }},
      {"AltA", Qt::Key_A, alt, freeze,
       [](auto&) {
         for (const QAction* action : window->actions())
           if (action->text() == "Live keeps A") return action->isChecked();
         return false;
       }},
      {"F6", Qt::Key_F6, none, focus_scene,
       [](auto&) { return !scene().isAncestorOf(QApplication::focusWidget()); }},
      {"ShiftF6", Qt::Key_F6, shift, focus_scene,
       [](auto&) { return !scene().isAncestorOf(QApplication::focusWidget()); }},
      {"F8", Qt::Key_F8, none, nothing, [](auto&) { return !window->sceneTree().isVisible(); }},
      {"F9", Qt::Key_F9, none, nothing, [](auto&) { return !window->settings().isVisible(); }},
      {"F11", Qt::Key_F11, none, nothing, [](auto&) { return window->isFullScreen(); }},
      {"F12", Qt::Key_F12, none, count_pictures,
       [](auto&) { return newest_picture().width() >= window->width(); }},
      {"ShiftF12", Qt::Key_F12, shift, count_pictures,
       [](auto&) {
         const QImage picture = newest_picture();
         return picture.width() >= scene().width() && picture.pixelColor(2, 2).alpha() == 0;
       }},
      {"CtrlShiftC", Qt::Key_C, ctrl | shift, [] { QApplication::clipboard()->clear(); },
       [](auto&) { return QApplication::clipboard()->image().width() >= scene().width(); }},
      {"CtrlQ", Qt::Key_Q, ctrl, nothing, [](auto&) { return !window->isVisible(); }},
  };
}

std::vector<KeyRow> all_rows() {
  std::vector<KeyRow> rows = transport_rows();
  for (const auto& more : {scene_rows(), program_rows()}) rows.insert(rows.end(), more.begin(), more.end());
  return rows;
}

class KeyOfTheKeymap : public KeyWindow, public testing::WithParamInterface<KeyRow> {};

TEST_P(KeyOfTheKeymap, DoesWhatItSays) {
  const KeyRow& row = GetParam();
  row.prepare();
  turn();
  const Before before{playback().cursor_s,  playback().speed,    ticker().shown()->index,          camera(),
                      scene().visibility(), scene().morphStep(), scene().options().cut_azimuth_rad};
  press(row.key, row.held);
  EXPECT_TRUE(until([&] { return row.effect(before); })) << window->messages().text().toStdString();
}

INSTANTIATE_TEST_SUITE_P(Keymap, KeyOfTheKeymap, testing::ValuesIn(all_rows()),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace
}  // namespace abrazo::app::keys_test
