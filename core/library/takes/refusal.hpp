#pragma once

#include "core/base/error.hpp"

namespace abrazo {

/// Thrown and caught within one reader, to leave several levels of recursion at the first error.
struct Refusal {
  Error error;
};

}  // namespace abrazo
