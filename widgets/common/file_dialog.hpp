#pragma once

#include <QString>
#include <QStringList>

class QWidget;

namespace abrazo::widgets {

/// Asks for existing files. @param folder  empty = where a file was chosen last
/// @return empty when the person cancels
QStringList choose_files(QWidget* parent, const QString& title, const QString& folder, const QString& filter);
QString choose_file(QWidget* parent, const QString& title, const QString& folder, const QString& filter);
QString choose_folder(QWidget* parent, const QString& title, const QString& folder);

/// Asks for the name of a file to be written. A name without an ending gets the usual one before the person
/// is asked whether a file may be replaced, so that the question is about the file that is written.
/// @param path       proposed folder and name
/// @param ending     with its dot; a chosen filter that names another one has that
/// @param is_asked   whether the person is asked before a file is replaced; false when the caller asks
/// @return empty when the person cancels
QString choose_new_file(QWidget* parent, const QString& title, const QString& path, const QString& ending,
                        const QString& filter, bool is_asked = true);

}  // namespace abrazo::widgets
