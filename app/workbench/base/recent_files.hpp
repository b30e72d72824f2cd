#pragma once

#include <QStringList>

namespace abrazo::app {

/// Files opened together, as one line of the settings, separated by line feeds.
using RecentEntry = QString;

constexpr int most_recent = 10;

/// @return the list with these files in front, each set of files once, the oldest dropped
QStringList with_recent(const QStringList& before, const QStringList& files);
QStringList files_of(const RecentEntry& entry);
/// The files that no longer exist.
QStringList missing_of(const RecentEntry& entry);
/// "walk.amc + body.asf", with the folder if another entry has the same names.
QString label_of(const RecentEntry& entry, const QStringList& all);

}  // namespace abrazo::app
