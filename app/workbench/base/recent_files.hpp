#pragma once

#include <QStringList>

namespace abrazo::app {

/// What was opened together, in one line of the settings: files divided by a line feed.
using RecentEntry = QString;

constexpr int most_recent = 10;

/// @return the list with these files in front, each set of files once, the oldest dropped
QStringList with_recent(const QStringList& before, const QStringList& files);
QStringList files_of(const RecentEntry& entry);
/// Those of them that no longer exist.
QStringList missing_of(const RecentEntry& entry);
/// "walk.amc + body.asf", with the folder where another entry has the same names.
QString label_of(const RecentEntry& entry, const QStringList& all);

}  // namespace abrazo::app
