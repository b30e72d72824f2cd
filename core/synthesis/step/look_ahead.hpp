#pragma once

#include <vector>

#include "core/library/store/motion_library.hpp"
#include "core/synthesis/frames/frame_result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// First row of the partner in the pairs of a frame: the body that is not at the user's place. The user's
/// role is not sufficient: frames of a recorded take have performer A first, whoever leads.
int partner_row(const FrameResult& frame);

/// The partner's next poses if the recording continues after the selected pair, placed relative to the user.
/// They include the path and turns of the user's recorded counterpart. World [m]; heights are those of the
/// recording. The first pose is the shown partner, the others follow every `step_s`; the edit of the shown
/// pose fades out.
/// @param library to which the candidates refer, with roles not exchanged
/// @param role     the user's
/// @return fewer poses at the end of the take; none if nothing was selected or the frame failed
std::vector<Pose> look_ahead(const FrameResult& frame, const MotionLibrary& library, UserRole role,
                             double seconds = 1, double step_s = 0.1);

}  // namespace abrazo
