#include "app/workbench/shell/layouts.hpp"

#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QUrl>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/shell/main_window.hpp"
#include "app/workbench/shell/panel_area.hpp"
#include "core/base/atomic_file.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app {
namespace {

QString last_file(const MainWindow& window) {
  return window.remembered().folder() + "/layout.json";
}

QString folder_of(const MainWindow& window) {
  return window.remembered().folder() + "/layouts";
}

}  // namespace

Layouts::Layouts(MainWindow& window) : QObject(&window), m_window(window) {}

QStringList Layouts::own() const {
  QStringList names;
  for (const QString& file : QDir(folder_of(m_window)).entryList({"*.json"}, QDir::Files, QDir::Name))
    names << QUrl::fromPercentEncoding(file.left(file.size() - 5).toUtf8());
  return names;
}

QString Layouts::fileOf(const QString& name) const {
  return folder_of(m_window) + "/" + QString::fromUtf8(QUrl::toPercentEncoding(name, " ")) + ".json";
}

bool Layouts::tell(const Status& done) {
  if (!done) m_window.messages().showError(words(done.error()));
  return bool(done);
}

void Layouts::showOnly(const QStringList& panels) {
  PanelArea& area = m_window.panels();
  area.reset();
  for (QDockWidget* panel : area.panels())
    if (area.isWanted(panel->objectName()) && !panels.contains(panel->objectName()))
      area.want(panel->objectName(), false);
}

bool Layouts::choose(const QString& name) {
  if (!builtIn().contains(name)) return restore(fileOf(name));
  m_window.resetLayout();
  if (name == "Tune") showOnly({"candidates", "settings", "plots"});
  if (name == "Present") showOnly({});
  return true;
}

bool Layouts::save(const QString& name) {
  if (name.trimmed().isEmpty()) return tell(Error{"a layout needs a name; give it one", "layout"});
  if (builtIn().contains(name))
    return tell(Error{"is the name of a layout that is built in; choose another name", name.toStdString()});
  QDir().mkpath(folder_of(m_window));
  const bool saved =
      tell(write_whole_file(fileOf(name).toStdString(), text_of(m_window.layoutOfPanels()).toStdString()));
  if (saved) emit ownChanged();
  return saved;
}

bool Layouts::remove(const QString& name) {
  if (!QFile::remove(fileOf(name)))
    return tell(
        Error{"cannot be deleted; check whether its folder can be written", fileOf(name).toStdString()});
  emit ownChanged();
  return true;
}

bool Layouts::restore(const QString& file) {
  const auto text = read_whole_file(file.toStdString());
  if (!text) return tell(text.error());
  const auto layout = parse_layout(QByteArray::fromStdString(*text), file.toStdString());
  if (!layout) return tell(layout.error());
  if (m_window.setLayoutOfPanels(*layout)) return true;
  return tell(Error{"does not fit this version of the window; arrange it and save the layout again",
                    file.toStdString()});
}

bool Layouts::restoreLast() {
  const QString file = last_file(m_window);
  if (!QFile::exists(file)) return false;
  if (restore(file)) return true;
  m_window.resetLayout();
  return false;
}

bool Layouts::saveLast() {
  return bool(
      write_whole_file(last_file(m_window).toStdString(), text_of(m_window.layoutOfPanels()).toStdString()));
}

}  // namespace abrazo::app
