#pragma once

namespace abrazo {

/// Asks the scheduler to run the calling thread before threads with long computations, because it works
/// often, briefly, and others wait for it. It gets no larger share of the processor and needs no privileges.
/// No effect on systems without support (Linux before 6.12) and on threads that already have a real-time
/// policy.
void let_this_thread_go_first();

}  // namespace abrazo
