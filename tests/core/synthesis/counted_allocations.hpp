#pragma once

#include <cstddef>

namespace abrazo::test {

/// How often this thread asked for heap memory so far, by operator new or by malloc and its kin; freeing does
/// not count. Counts in every function that is linked into the same program.
std::size_t allocations();

}  // namespace abrazo::test
