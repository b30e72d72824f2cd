#pragma once

#include "core/annotation/annotations.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// A take with what was said of the session while it was recorded: moves where the take has none, roles where
/// nobody said who leads. A role that is none is left out.
/// @param began_s  session time of the take's first frame
PairedTake with_session_labels(PairedTake take, const Annotations& session, double began_s);

}  // namespace abrazo
