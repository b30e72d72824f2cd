#pragma once

#include <QString>
#include <QStringList>

#include "core/session/export/export_plan.hpp"

namespace abrazo::app {

/// What a file type is, for a list. @param ending  ".glb"
QString export_type_words(const QString& ending);
/// The same of a type that a character is written as.
QString character_type_words(const QString& ending);
/// All of them, for the width of a list.
QStringList all_export_type_words();

/// What the files will hold, as far as their type does not say it, and who cannot read that.
QString export_content_words(const ExportWish& wish);

/// The number of frames, their rate and the size of the file; in a second line those that no pose was
/// recorded for.
QString export_plan_words(const ExportWish& wish, const ExportPlan& plan);

}  // namespace abrazo::app
