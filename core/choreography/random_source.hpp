#pragma once

#include <cstdint>
#include <random>

namespace abrazo {

/// Random numbers that are identical with every standard library (std distributions are not).
class RandomSource {
 public:
  explicit RandomSource(std::uint64_t seed) : engine_(seed) {}

  /// [low, high)
  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }
  /// 0 .. count - 1
  int below(int count) { return static_cast<int>(uniform(0, count)); }
  /// Bell-shaped with mean 0 and standard deviation 1, never beyond 3.
  double bell() { return 2 * (uniform(-0.5, 0.5) + uniform(-0.5, 0.5) + uniform(-0.5, 0.5)); }
  bool chance(double probability) { return uniform(0, 1) < probability; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace abrazo
