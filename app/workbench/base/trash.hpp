#pragma once

#include <QString>
#include <QStringList>

#include "core/base/result.hpp"

namespace abrazo::app {

/// Moves files that belong together to the trash of the desktop: all of them, or none. Files that are not
/// there are skipped. An Error, and every file in its place, if there is no trash.
Status move_to_trash(const QStringList& files);

}  // namespace abrazo::app
