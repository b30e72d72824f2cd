#pragma once

#include "core/base/error.hpp"

namespace abrazo {

/// Thrown and caught within one reader: reading descends several levels and ends at the first mistake.
struct Refusal {
  Error error;
};

}  // namespace abrazo
