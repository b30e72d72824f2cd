#pragma once

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/session/export/export_source.hpp"
#include "core/session/export/export_wish.hpp"

namespace abrazo {

/// Writes what is wished for: all of its files, or none of them. The one way of exporting, for the window and
/// the command line. @return an Error when nothing was written, also because `progress` asked to stop
Result<ExportReport> export_session(ExportSource& source, const ExportWish& wish,
                                    const Progress& progress = {});

}  // namespace abrazo
