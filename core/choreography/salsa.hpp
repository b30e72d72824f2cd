#pragma once

#include <vector>

#include "core/base/progress.hpp"
#include "core/choreography/choreography_options.hpp"
#include "core/library/takes/paired_take.hpp"

namespace abrazo {

/// Salsa pairs: performer A leads. The paper's six categories in random order, about equally frequent, one to
/// an 8-count and joined without a seam: open and closed holds, turns of either dancer, cross body leads,
/// walks, in and out. Hands that hold one another meet, planted feet stand still, bone lengths are constant,
/// however well it is performed. Labels are true by geometry, in whole turns relative to the partner.
/// @param progress  told of every take; when it says stop, the takes so far are returned
/// @throws std::invalid_argument when an option is out of range
std::vector<PairedTake> generate_salsa(const ChoreographyOptions& options, const Progress& progress = {});

}  // namespace abrazo
