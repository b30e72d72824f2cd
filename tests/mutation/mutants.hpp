#pragma once

// Included before every source of a mutated build (tests/mutation/mutate). One mutant is active in a
// process: the one that ABRAZO_MUTANT names. ABRAZO_MUTANTS_REACHED names a folder in which each process
// leaves the numbers of the mutants that it came past.

#include <unistd.h>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace abrazo_mutation {

inline constexpr int most = 1 << 16;
inline unsigned char reached[most] = {};
inline int active = -1;

__attribute__((constructor(101))) inline void read_active() {
  if (const char* text = std::getenv("ABRAZO_MUTANT")) active = std::atoi(text);
}

__attribute__((destructor)) inline void write_reached() {
  const char* folder = std::getenv("ABRAZO_MUTANTS_REACHED");
  if (folder == nullptr) return;
  const std::string path = std::string(folder) + "/" + std::to_string(getpid());
  if (std::FILE* file = std::fopen(path.c_str(), "w")) {
    for (int id = 0; id < most; ++id)
      if (reached[id] != 0) std::fprintf(file, "%d\n", id);
    std::fclose(file);
  }
}

inline bool on(int id) {
  reached[id] = 1;
  return id == active;
}

template <class A, class B>
auto less(int id, const A& a, const B& b) {
  return on(id) ? a <= b : a < b;
}
template <class A, class B>
auto less_equal(int id, const A& a, const B& b) {
  return on(id) ? a < b : a <= b;
}
template <class A, class B>
auto greater(int id, const A& a, const B& b) {
  return on(id) ? a >= b : a > b;
}
template <class A, class B>
auto greater_equal(int id, const A& a, const B& b) {
  return on(id) ? a > b : a >= b;
}
template <class A, class B>
auto equal(int id, const A& a, const B& b) {
  return on(id) ? a != b : a == b;
}
template <class A, class B>
auto not_equal(int id, const A& a, const B& b) {
  return on(id) ? a == b : a != b;
}
template <class A, class B>
auto plus(int id, const A& a, const B& b) {
  return on(id) ? a - b : a + b;
}
template <class A, class B>
auto minus(int id, const A& a, const B& b) {
  return on(id) ? a + b : a - b;
}
template <class A, class B>
auto times(int id, const A& a, const B& b) {
  return on(id) ? a / b : a * b;
}
template <class A, class B>
auto divides(int id, const A& a, const B& b) {
  return on(id) ? a * b : a / b;
}

}  // namespace abrazo_mutation
