#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "core/base/atomic_file.hpp"
#include "core/motion/joints/named_motion.hpp"

namespace abrazo::test {

inline std::filesystem::path motion_fixture(const std::string& name) {
  return std::filesystem::path(ABRAZO_FIXTURES) / "motion" / name;
}

/// The bytes of a file in tests/fixtures/motion.
inline std::string fixture_text(const std::string& name) {
  return read_whole_file(motion_fixture(name)).value();
}

/// The one warning of that kind; fails when there is none or several.
inline ImportWarning the_warning(const std::vector<ImportWarning>& warnings, const std::string& kind) {
  const auto is_it = [&](const ImportWarning& warning) { return warning.kind == kind; };
  EXPECT_EQ(std::count_if(warnings.begin(), warnings.end(), is_it), 1) << "warnings of kind " << kind;
  const auto found = std::find_if(warnings.begin(), warnings.end(), is_it);
  return found == warnings.end() ? ImportWarning{} : *found;
}

inline bool has_warning(const std::vector<ImportWarning>& warnings, const std::string& kind) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const ImportWarning& w) { return w.kind == kind; });
}

/// Place of a named point in one frame, file units.
inline Vec3 place(const NamedMotion& motion, std::size_t frame, const std::string& point) {
  const auto found = std::find(motion.points.begin(), motion.points.end(), point);
  if (found == motion.points.end()) {
    ADD_FAILURE() << "no point '" << point << "'";
    return Vec3::Zero();
  }
  return motion.frames.at(frame).row(found - motion.points.begin()).transpose();
}

/// A text with a few characters changed, cut out or doubled.
inline std::string damaged(std::string text, std::mt19937& random) {
  const std::string characters = "0123456789.-+eE,{}:# \t\n\rXYZaxr\xff";
  for (unsigned i = 1 + random() % 4; i > 0 && text.size() > 8; --i) {
    const std::size_t at = random() % (text.size() - 8);
    switch (random() % 3) {
      case 0:
        text[at] = characters[random() % characters.size()];
        break;
      case 1:
        text.erase(at, 1 + random() % 8);
        break;
      default:
        text.insert(at, text.substr(random() % (text.size() - 8), 1 + random() % 8));
    }
  }
  return text;
}

/// 1e-12 of the file's units: the readers and the tests multiply the same few rotations in different order.
inline void expect_near(const Vec3& found, const Vec3& expected, double tolerance = 1e-12) {
  EXPECT_LT((found - expected).norm(), tolerance)
      << "found " << found.transpose() << ", expected " << expected.transpose();
}

}  // namespace abrazo::test
