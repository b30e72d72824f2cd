#include "widgets/common/theme.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QFontDatabase>
#include <QPalette>
#include <QPointer>
#include <QStyle>
#include <QStyleFactory>
#include <QTimer>
#include <QWidget>
#include <optional>
#include <vector>

/// A static library's resources must be initialised explicitly; the macro must be outside namespaces.
static void load_resources() {
  Q_INIT_RESOURCE(resources);
}

#include "widgets/common/qt_versions.hpp"

namespace abrazo::widgets {
namespace {

// %1 window %2 panel %3 raised %4 border %5 text %6 secondary %7 accent %8 hover %10 warning
constexpr const char* sheet = R"(
QMainWindow, QDialog { background: %1; color: %5; }
QMenuBar { background: %2; border-bottom: 1px solid %4; padding: 1px 0; }
QMenuBar::item { padding: 5px 7px; background: transparent; border-radius: 4px; }
QMenuBar::item:selected { background: %3; }
QMenu { background: %2; border: 1px solid %4; padding: 4px; }
QMenu::item { padding: 5px 28px 5px 24px; border-radius: 4px; }
QMenu::item:selected { background: %7; color: #ffffff; }
QMenu::item:disabled { color: %6; }
QMenu::separator { height: 1px; background: %4; margin: 4px 8px; }
QStatusBar { background: %2; border-top: 1px solid %4; }
QStatusBar::item { border: none; }
QDockWidget { border: none; }
QDockWidget > QWidget { background: %2; }
QMainWindow::separator { background: %4; width: 1px; height: 1px; }
QMainWindow::separator:hover { background: %7; }
QTabBar { background: %2; }
QTabBar::tab { background: %2; color: %6; padding: 5px 11px; border: none; border-bottom: 2px solid transparent; }
QTabBar::tab:hover { color: %5; }
QTabBar::tab:selected { color: %5; border-bottom: 2px solid %7; }
QTabBar::scroller { width: 36px; }
QTabBar QToolButton { background: %2; border: none; }
QTabBar QToolButton:hover { background: %3; }
QSplitter::handle { background: %4; }
QToolTip { background: %1; color: %5; border: 1px solid %4; padding: 5px 7px; }
QFrame#panel, QWidget#panel { background: %2; }
QFrame#rule { background: %4; border: none; }
QLabel#secondary { color: %6; }
QLabel#warning { color: %10; }
QFrame#entryFrame { background: %1; border: 1px solid %7; border-radius: 6px; }
QFrame#popup { background: %2; border: 1px solid %6; border-radius: 6px; }
QToolButton#flat, QPushButton#flat { border: none; background: transparent; padding: 3px; border-radius: 5px; }
QToolButton#flat:hover, QPushButton#flat:hover { background: %3; }
QToolButton#quiet { border: 1px solid transparent; background: transparent; border-radius: 4px; }
QToolButton#quiet:hover { background: %3; }
QToolButton#quiet:focus { border-color: %7; }
QToolButton#quiet::menu-indicator { image: none; width: 0; }
QToolButton#chip { background: %3; border: 1px solid %4; border-radius: 5px; padding: 3px 9px; color: %5; }
QToolButton#chip:hover { border-color: %6; }
QToolButton#chip::menu-indicator, QToolButton#segment::menu-indicator { image: none; width: 0; }
QToolButton#chip:checked { background: %7; border-color: %7; color: #ffffff; }
QToolButton#segment { background: %1; border: 1px solid %4; border-left: none; padding: 4px 6px; color: %6; }
QToolButton#segment[first="true"] { border-left: 1px solid %4; border-top-left-radius: 5px; border-bottom-left-radius: 5px; }
QToolButton#segment[last="true"] { border-top-right-radius: 5px; border-bottom-right-radius: 5px; }
QToolButton#segment:hover { color: %5; }
QToolButton#segment:checked { background: %7; color: #ffffff; }
QPushButton { background: %3; border: 1px solid %4; border-radius: 5px; padding: 4px 12px; }
QPushButton#small { padding: 3px 8px; }
QPushButton:hover { border-color: %6; }
QPushButton#link { border: 1px solid transparent; background: transparent; text-align: left; margin: 0 6px; padding: 2px 6px; }
QPushButton#link:hover { background: %3; }
QPushButton#link:focus { border-color: %7; }
QPushButton:focus { border-color: %7; }
QPushButton:default { background: %7; border-color: %7; color: #ffffff; }
QPushButton:default:disabled { background: %3; border-color: %4; color: %6; }
QLineEdit { background: %1; border: 1px solid %4; border-radius: 5px; padding: 3px 8px; selection-background-color: %7; selection-color: #ffffff; }
QLineEdit:focus { border-color: %7; }
QLineEdit#value { background: transparent; border: 1px solid transparent; border-radius: 4px; padding: 0 2px; }
QLineEdit#value:hover { border-color: %4; }
QLineEdit#value:focus { background: %1; border-color: %7; }
QComboBox { background: %1; border: 1px solid %4; border-radius: 5px; padding: 2px 8px; min-height: 18px; combobox-popup: 0; }
QComboBox:hover, QComboBox:focus { border-color: %6; }
QComboBox::drop-down { border: none; width: 18px; }
QComboBox::down-arrow { image: url(:/abrazo/icons/chevron_%9.svg); width: 10px; height: 10px; }
QComboBox QAbstractItemView { background: %2; border: 1px solid %4; selection-background-color: %7; selection-color: #ffffff; outline: 0; }
QAbstractSpinBox { background: %1; border: 1px solid %4; border-radius: 5px; padding: 2px 18px 2px 8px; min-height: 18px; }
QAbstractSpinBox[buttonSymbols="2"] { padding-right: 8px; }
QAbstractSpinBox:hover, QAbstractSpinBox:focus { border-color: %6; }
QAbstractSpinBox::up-button, QAbstractSpinBox::down-button { background: transparent; border: none; width: 16px; }
QAbstractSpinBox::up-arrow { image: url(:/abrazo/icons/chevron_up_%9.svg); width: 8px; height: 8px; }
QAbstractSpinBox::down-arrow { image: url(:/abrazo/icons/chevron_%9.svg); width: 8px; height: 8px; }
QScrollArea { background: transparent; border: none; }
QScrollBar:vertical { background: transparent; width: 8px; margin: 0; }
QScrollBar::handle:vertical { background: %8; border-radius: 3px; min-height: 24px; margin: 1px; }
QScrollBar::handle:vertical:hover { background: %6; }
QScrollBar:horizontal { background: transparent; height: 8px; margin: 0; }
QScrollBar::handle:horizontal { background: %8; border-radius: 3px; min-width: 24px; margin: 1px; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QTableView, QTreeView { background: %2; border: none; gridline-color: %4; selection-background-color: %7; selection-color: #ffffff; outline: 0; }
QHeaderView, QTableCornerButton::section { background: %2; border: none; }
QHeaderView::section { background: %2; color: %6; border: none; border-bottom: 1px solid %4; padding: 5px 6px; }
QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
QDialog QTreeView::item { padding: 3px 2px; }
QDialog QTableView, QDialog QTreeView, QDialog QListView { border: 1px solid %4; border-radius: 5px; }
QProgressBar { background: %3; border: none; border-radius: 3px; text-align: center; }
QProgressBar::chunk { background: %7; border-radius: 3px; }
QSlider:horizontal { min-height: 18px; }
QSlider::groove:horizontal { background: %8; height: 3px; border-radius: 1px; }
QSlider::sub-page:horizontal { background: %7; height: 3px; border-radius: 1px; }
QSlider::handle:horizontal { background: #ffffff; border: 2px solid %7; width: 8px; margin: -5px 0; border-radius: 6px; }
QSlider::sub-page:horizontal:disabled { background: %8; }
QSlider::handle:horizontal:disabled { background: %3; border-color: %8; }
QListView { background: %2; border: 1px solid %4; outline: 0; }
QListView#bare { background: transparent; border: none; }
QListView::item { padding: 4px 8px; }
QListView::item:selected { background: %7; color: #ffffff; }
QCheckBox::indicator, QListView::indicator, QTreeView::indicator { width: 12px; height: 12px; background: %1; border: 1px solid %6; border-radius: 3px; }
QCheckBox::indicator:checked, QListView::indicator:checked, QTreeView::indicator:checked { background: %7; border-color: %7; image: url(:/abrazo/icons/check.svg); }
QCheckBox::indicator:focus { border-color: %7; }
QCheckBox::indicator:checked:focus { border-color: %5; }
QCheckBox::indicator:disabled { border-color: %4; background: %1; }
QListView::indicator:selected, QTreeView::indicator:selected { border-color: #ffffff; }
)";

/// Themes differ in colours only. Qt would tell every widget of a new style, and lay out and measure all of
/// them anew.
class OnlyColoursChange : public QObject {
 public:
  explicit OnlyColoursChange(QApplication& application) : m_application(application) {
    application.installEventFilter(this);
  }
  ~OnlyColoursChange() override {
    m_application.removeEventFilter(this);
    for (QWidget* window : QApplication::topLevelWidgets()) window->update();
  }
  OnlyColoursChange(const OnlyColoursChange&) = delete;
  OnlyColoursChange& operator=(const OnlyColoursChange&) = delete;
  bool eventFilter(QObject*, QEvent* event) override { return event->type() == QEvent::StyleChange; }

 private:
  QApplication& m_application;
};

/// Qt polishes all widgets for a new sheet at once, and most of them twice. Here those that are shown get it
/// in several turns of the event loop, and a window is painted again when all of its widgets have it; hidden
/// ones (closed panels, dialogs, menus) get it when they are shown. A widget needs no unpolishing in between,
/// because each sheet sets the same properties.
class LatePolish : public QObject {
 public:
  using QObject::QObject;

  /// Before the sheet changes.
  void putOff() {
    m_waiting.clear();
    for (QWidget* widget : QApplication::allWidgets()) {
      if (is_desktop(*widget)) continue;
      widget->setAttribute(Qt::WA_WState_Polished, false);
      if (!widget->isVisible()) continue;
      m_waiting.emplace_back(widget);
      if (widget->isWindow()) widget->setUpdatesEnabled(false);
    }
    goOnLater();
  }
  bool isWaiting() const { return !m_waiting.empty(); }

  bool eventFilter(QObject* receiver, QEvent* event) override {
    if (event->type() == QEvent::Show && receiver->isWidgetType()) polish(*static_cast<QWidget*>(receiver));
    return false;
  }

 private:
  static void polish(QWidget& widget) {
    if (widget.testAttribute(Qt::WA_WState_Polished)) return;
    widget.style()->polish(&widget);
    widget.setAttribute(Qt::WA_WState_Polished);
  }

  void goOnLater() {
    if (m_waiting.empty() || m_goesOn) return;
    m_goesOn = true;
    QTimer::singleShot(1, this, &LatePolish::goOn);  // at 0 it would wait until there is nothing else to do
  }

  void goOn() {
    constexpr qint64 enough_ms = 10;
    m_goesOn = false;
    QElapsedTimer clock;
    clock.start();
    for (; !m_waiting.empty() && clock.elapsed() < enough_ms; m_waiting.pop_back())
      if (QWidget* widget = m_waiting.back()) polish(*widget);
    if (m_waiting.empty())
      for (QWidget* window : QApplication::topLevelWidgets()) {
        window->setUpdatesEnabled(true);
        // What was to be painted before stayed so when its request came while nothing was painted. Qt then
        // sends no other one, and the window would never be painted again.
        QCoreApplication::postEvent(window, new QEvent(QEvent::UpdateRequest));
      }
    goOnLater();
  }

  std::vector<QPointer<QWidget>> m_waiting;
  bool m_goesOn = false;
};

QPointer<LatePolish> late_polish;

}  // namespace

QFont interface_font(int pixel_size, QFont::Weight weight) {
  static const bool has_inter = QFontDatabase().families().contains("Inter");
  QFont font = has_inter ? QFont("Inter") : QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  font.setPixelSize(pixel_size);
  font.setWeight(weight);
  return font;
}

QString style_sheet(const Palette& p) {
  const auto name = [](const QColor& colour) { return colour.name(); };
  return QString(sheet)
      .arg(name(p.window), name(p.panel), name(p.raised), name(p.border), name(p.text), name(p.secondary),
           name(p.accent), name(mixed(p.secondary, p.panel, 0.35)), p.dark ? "dark" : "light")
      .arg(name(p.warning));
}

void apply_theme(QApplication& application, const Palette& p) {
  load_resources();
  // Each of these visits every widget; only colours change later.
  std::optional<OnlyColoursChange> colours_only;
  if (application.styleSheet().isEmpty()) {
    application.setStyle(QStyleFactory::create("Fusion"));
    application.setFont(interface_font());
    late_polish = new LatePolish(&application);
    application.installEventFilter(late_polish);
  } else {
    colours_only.emplace(application);
    late_polish->putOff();
    // Qt 5 polishes a widget once for each of its parents where a sheet replaces another, and once where it
    // is the first.
    application.setStyleSheet({});
  }
  QPalette colours;
  colours.setColor(QPalette::Window, p.window);
  colours.setColor(QPalette::Base, p.panel);
  colours.setColor(QPalette::AlternateBase, p.raised);
  colours.setColor(QPalette::Button, p.raised);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText})
    colours.setColor(role, p.text);
  colours.setColor(QPalette::PlaceholderText, p.secondary);
  colours.setColor(QPalette::ToolTipBase, p.window);
  colours.setColor(QPalette::Link, p.dark ? p.active.lighter(125) : p.active);
  colours.setColor(QPalette::Highlight, p.accent);
  colours.setColor(QPalette::HighlightedText, Qt::white);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    colours.setColor(QPalette::Disabled, role, p.secondary);
  application.setPalette(colours);
  application.setStyleSheet(style_sheet(p));
}

bool is_applying_theme() {
  return late_polish && late_polish->isWaiting();
}

}  // namespace abrazo::widgets
