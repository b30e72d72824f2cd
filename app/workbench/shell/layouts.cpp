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

QString Layouts::fileOfTask(const QString& task) const {
  return m_window.remembered().folder() + "/layout-" + task.toLower() + ".json";
}

void Layouts::showOnly(const QStringList& panels) {
  PanelArea& area = m_window.panels();
  for (QDockWidget* panel : area.panels())
    area.want(panel->objectName(), panels.contains(panel->objectName()));
}

void Layouts::reset() {
  m_window.resetLayout();
  if (m_task == "Annotate") {
    showOnly({"library", "annotation"});
    m_window.makeRoomForLanes();
  }
  if (m_task == "Live") showOnly({"scene", "connection", "recording"});
}

bool Layouts::choose(const QString& name) {
  if (!builtIn().contains(name)) return restore(fileOf(name));
  m_before.clear();
  if (name == m_task) return true;
  m_kept[m_task] = m_window.layoutOfPanels();
  m_task = name;
  const auto kept = m_kept.find(name);
  if (kept == m_kept.end() || !m_window.setLayoutOfPanels(kept->second)) reset();
  emit taskChanged(name);
  return true;
}

void Layouts::beginLive() {
  if (m_followsWork) choose("Live");
}

void Layouts::showTake(bool on) {
  if (!m_followsWork) return;
  if (on && m_task != "Annotate") {
    const QString before = m_task;
    choose("Annotate");
    m_before = before;
  } else if (!on && !m_before.isEmpty()) {
    choose(QString(m_before));
  }
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
  for (const QString& task : builtIn()) {
    const auto text = read_whole_file(fileOfTask(task).toStdString());
    const auto layout = text ? parse_layout(QByteArray::fromStdString(*text), fileOfTask(task).toStdString())
                             : Result<WindowLayout>(text.error());
    if (layout) m_kept[task] = *layout;
  }
  const QString last = m_window.remembered().task();
  if (builtIn().contains(last)) m_task = last;
  emit taskChanged(m_task);
  const QString file = fileOfTask(m_task);
  if (!QFile::exists(file)) {
    if (m_task != "Inspect") reset();
    return false;
  }
  if (restore(file)) return true;
  reset();
  return false;
}

bool Layouts::saveLast() {
  m_window.remembered().setTask(m_task);
  m_kept[m_task] = m_window.layoutOfPanels();
  bool saved = true;
  for (const auto& [task, layout] : m_kept)
    saved = write_whole_file(fileOfTask(task).toStdString(), text_of(layout).toStdString()).ok() && saved;
  return saved;
}

}  // namespace abrazo::app
