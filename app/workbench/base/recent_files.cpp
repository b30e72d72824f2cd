#include "app/workbench/base/recent_files.hpp"

#include <QFileInfo>
#include <algorithm>

namespace abrazo::app {
namespace {

QString names_of(const RecentEntry& entry) {
  QStringList names;
  for (const QString& file : files_of(entry)) names << QFileInfo(file).fileName();
  return names.join(" + ");
}

}  // namespace

QStringList files_of(const RecentEntry& entry) {
  return entry.split('\n', Qt::SkipEmptyParts);
}

QStringList with_recent(const QStringList& before, const QStringList& files) {
  QStringList absolute;
  for (const QString& file : files) absolute << QFileInfo(file).absoluteFilePath();
  absolute.sort();
  const RecentEntry entry = absolute.join('\n');
  QStringList after = before;
  after.removeAll(entry);
  if (!entry.isEmpty()) after.prepend(entry);
  return after.mid(0, most_recent);
}

QStringList missing_of(const RecentEntry& entry) {
  QStringList missing;
  for (const QString& file : files_of(entry))
    if (!QFileInfo::exists(file)) missing << file;
  return missing;
}

QString label_of(const RecentEntry& entry, const QStringList& all) {
  const QString names = names_of(entry);
  const bool is_alone =
      std::ranges::count_if(all, [&](const QString& other) { return names_of(other) == names; }) < 2;
  return is_alone ? names : names + " in " + QFileInfo(files_of(entry).value(0)).absolutePath();
}

}  // namespace abrazo::app
