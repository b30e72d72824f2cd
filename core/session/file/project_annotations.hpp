#pragma once

#include "core/annotation/annotations.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/table_reader.hpp"

namespace abrazo {

/// Replaces all annotations of the file, in the running transaction.
Status write_annotations(SessionDatabase& database, const AnnotationBook& book);

/// Reads all valid annotations. A tier, annotation or suggestion that conflicts with the others is left out
/// and counted.
AnnotationBook read_annotations(TableReader& tables);

}  // namespace abrazo
