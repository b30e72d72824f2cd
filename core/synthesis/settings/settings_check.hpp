#pragma once

#include "core/base/result.hpp"
#include "core/synthesis/settings/settings.hpp"

namespace abrazo {

/// Checks that every setting is within the range of all_settings(); the Error names the first that is not.
/// For settings filled in by a program.
Status check_settings(const Settings& settings);

}  // namespace abrazo
