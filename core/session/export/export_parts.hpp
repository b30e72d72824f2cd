#pragma once

#include "core/session/export/exporting.hpp"

namespace abrazo {

inline void write_range(JsonText& json, const SessionRange& range) {
  json.key("from_s").value(range.from_s).key("to_s").value(range.to_s);
}

inline Error cancelled(const SessionRecord& session) {
  return {"cancelled; nothing was written", session.where()};
}

// One function per kind of content; they expect a checked wish.
Result<ExportReport> export_motion(const ExportSource& source, const ExportWish& wish,
                                   const Progress& progress);
Result<ExportReport> export_mesh(ExportSource& source, const ExportWish& wish, const Progress& progress);
Result<ExportReport> export_labels(const ExportSource& source, const ExportWish& wish,
                                   const Progress& progress);
Result<ExportReport> export_trace(ExportSource& source, const ExportWish& wish, const Progress& progress);

}  // namespace abrazo
