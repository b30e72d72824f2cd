#pragma once

#include <vector>

#include "core/base/progress.hpp"
#include "core/choreography/choreography_options.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// Salsa pairs: performer A leads. The paper's six categories in random order, about equally frequent, one
/// per 8-count and joined smoothly: open and closed holds, turns of either dancer, cross body leads, walks,
/// in and out. At every skill, held hands meet, planted feet do not slide, and bone lengths are constant.
/// Labels agree with the geometry, in whole turns relative to the partner.
/// @param progress called for every take; after cancellation the takes so far are returned
/// @throws std::invalid_argument if an option is out of range
std::vector<PairedTake> generate_salsa(const ChoreographyOptions& options, const Progress& progress = {});

}  // namespace abrazo
