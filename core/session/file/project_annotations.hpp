#pragma once

#include "core/annotation/annotations.hpp"
#include "core/session/file/session_database.hpp"
#include "core/session/file/table_reader.hpp"

namespace abrazo {

/// In place of all annotations of the file, in the running transaction.
Status write_annotations(SessionDatabase& database, const AnnotationBook& book);

/// What can be read; a tier, annotation or suggestion that cannot stand beside the others is left out and
/// counted.
AnnotationBook read_annotations(TableReader& tables);

}  // namespace abrazo
