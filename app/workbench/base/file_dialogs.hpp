#pragma once

#include <QStringList>

class QWidget;

namespace abrazo::app {

class UserSettings;

/// Asks for files to open, in the folder used last, which follows the answer. Empty if the person cancels.
QStringList ask_files(QWidget* parent, UserSettings& remembered, const QString& title, const QString& filter);
/// Asks for one file, likewise.
QString ask_file(QWidget* parent, UserSettings& remembered, const QString& title, const QString& filter);
/// Asks for a file to write, likewise.
/// @param ending  ".csv", appended to a name that is typed without one
QString ask_new_file(QWidget* parent, UserSettings& remembered, const QString& title, const QString& name,
                     const QString& ending, const QString& filter);

}  // namespace abrazo::app
