#pragma once

#include <filesystem>
#include <optional>

namespace abrazo::test {

/// Folder of the captured motions that the repository does not contain (data/README.md says how to obtain
/// them), or nothing. ABRAZO_DATA names it; otherwise it is looked for beside the checkout.
std::optional<std::filesystem::path> captured_data();

}  // namespace abrazo::test

/// First line of a test that needs the captured motions.
#define ABRAZO_REQUIRE_CAPTURED_DATA(folder)                                                        \
  const auto folder##_or_none = abrazo::test::captured_data();                                      \
  if (!folder##_or_none) GTEST_SKIP() << "captured motions not found; set ABRAZO_DATA to try this"; \
  const std::filesystem::path folder = *folder##_or_none
