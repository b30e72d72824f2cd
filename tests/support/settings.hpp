#pragma once

#include "core/synthesis/settings/settings.hpp"

namespace abrazo::test {

/// The preset `responsive`, selecting by Eq. 7 from the first frame on: what a live loop selects by does not
/// depend on when the library has been learned.
inline Settings responsive_by_pose() {
  Settings settings = *preset("responsive");
  settings.selection = SelectionMethod::Paper;
  return settings;
}

/// The same, selecting by the user's intent.
inline Settings responsive_by_intent() {
  Settings settings = *preset("responsive");
  settings.selection = SelectionMethod::Intent;
  return settings;
}

}  // namespace abrazo::test
