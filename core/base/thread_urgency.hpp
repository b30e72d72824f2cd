#pragma once

namespace abrazo {

/// Asks the scheduler to run the calling thread before threads with long computations, because it works
/// often, briefly, and others wait for it. Needs no privileges; a higher priority is asked for, too, and most
/// users do not get it. No effect on systems without support (Linux before 6.12) and on threads that already
/// have a real-time policy.
/// @param work_s  longest work at a time: the scheduler lets no other thread in before. A thread that asks
///                for less is interrupted by long computations until the next tick, 4 ms with most kernels;
///                one that asks for more starts later
void let_this_thread_go_first(double work_s);

/// Lowers the priority of the calling thread, and of those that it starts: it computes for long, and whoever
/// draws or answers should not wait for it where cores are short.
void let_others_go_first();

}  // namespace abrazo
