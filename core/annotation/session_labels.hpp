#pragma once

#include "core/annotation/annotations.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// A take with the session's annotations during its recording: moves if the take has none, roles if it has
/// none. Invalid roles are left out.
/// @param began_s  session time of the take's first frame
PairedTake with_session_labels(PairedTake take, const Annotations& session, double began_s);

}  // namespace abrazo
