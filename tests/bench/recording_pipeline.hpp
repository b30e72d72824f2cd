#pragma once

// core/synthesis/step/frame_pipeline.hpp as RecordingPipeline.
#include "core/library/store/motion_library.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"
#include "tests/bench/recording_names.hpp"
// clang-format off
#include "core/synthesis/step/frame_pipeline.hpp"
// clang-format on

#undef ConstrainedSolver
#undef PairEditor
#undef FramePipeline
#undef exchange_roles
