#pragma once

#include "core/base/result.hpp"
#include "core/synthesis/settings.hpp"

namespace abrazo {

/// Whether every setting is within the range of all_settings(); an Error names the first that is not. For
/// those that a program filled in by itself.
Status check_settings(const Settings& settings);

}  // namespace abrazo
