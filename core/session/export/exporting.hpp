#pragma once

#include "core/base/progress.hpp"
#include "core/base/result.hpp"
#include "core/session/export/export_source.hpp"
#include "core/session/export/export_wish.hpp"

namespace abrazo {

/// Writes all files of a wish, or none. The window and the command line both export through it. @return an
/// Error if nothing was written, also if `progress` cancelled
Result<ExportReport> export_session(ExportSource& source, const ExportWish& wish,
                                    const Progress& progress = {});

}  // namespace abrazo
