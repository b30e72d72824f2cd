#pragma once

#include <chrono>

namespace abrazo {

/// Time since `begin` [us].
inline double elapsed_us(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace abrazo
