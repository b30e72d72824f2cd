#pragma once

#include <QColor>
#include <QString>
#include <string_view>

#include "core/annotation/annotations.hpp"
#include "widgets/common/palette.hpp"

namespace abrazo::widgets {

/// The colour of a value: its vocabulary's, else that of performer A or B, else that of the move.
QColor value_colour(const Palette& palette, const AnnotationTier& tier, std::string_view value);

/// Text of a value: "A leads", "closed hold".
QString value_words(const AnnotationTier& tier, std::string_view value);

}  // namespace abrazo::widgets
