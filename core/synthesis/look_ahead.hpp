#pragma once

#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/synthesis/frame_result.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

/// First row of the partner in the pairs of a frame: of the two bodies the one that is not where the user is.
/// The user's role does not say it everywhere: frames of a recorded take have performer A in front, whoever
/// leads.
int partner_row(const FrameResult& frame);

/// The partner's next moments if the recording goes on after the selected pair, where the user is: what the
/// user's recorded counterpart walks and turns meanwhile is in them. World [m]; heights are those of the
/// recording. The first pose is the partner that is shown, the others follow each `step_s`, and what the
/// shown one has been edited by fades out.
/// @param library  that the candidates are numbered in, with its roles not exchanged
/// @param role     the user's
/// @return fewer poses where the take ends; none where nothing was selected or the frame failed
std::vector<Pose> look_ahead(const FrameResult& frame, const MotionLibrary& library, UserRole role,
                             double seconds = 1, double step_s = 0.1);

}  // namespace abrazo
