#include "widgets/common/selection_model.hpp"
