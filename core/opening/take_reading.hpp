#pragma once

#include "core/base/result.hpp"
#include "core/library/takes/manifest.hpp"
#include "core/motion/files/motion_reading.hpp"
#include "core/opening/material.hpp"

namespace abrazo {

/// One of the two performers of a take.
enum class Performer { A, B };

/// The manifest that the library was built from: the one that is kept, or the file that was opened. An Error
/// where the library is a file that does not say what it was built from.
Result<Manifest> manifest_behind(const Material& material);

/// How a performer of the take is read.
MotionReading reading_of(const Manifest::Take& take, Performer performer);

/// The take with a performer that is read so. Both performers have one rate.
/// @param index  of the performer in its file, from 0
/// @return an Error for what a manifest cannot say: a floor, which each take finds for itself
Result<Manifest::Take> with_reading(Manifest::Take take, Performer performer, const MotionReading& reading,
                                    int index);

}  // namespace abrazo
