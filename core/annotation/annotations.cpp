#include "core/annotation/annotations.hpp"
