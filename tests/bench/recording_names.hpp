#pragma once

// Comes before the production sources of editor and pipeline where they are compiled a second time (see
// CMakeLists.txt): their classes get names of their own, and the solver in them is the one that records.
#include "tests/bench/recording_solver.hpp"

#define ConstrainedSolver RecordingSolver
#define PairEditor RecordingEditor
#define FramePipeline RecordingPipeline
#define exchange_roles exchange_roles_of_recording
