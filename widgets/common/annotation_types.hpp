#pragma once

#include <QMetaType>

#include "core/annotation/annotations.hpp"

// Carried by signals: Qt 6 wants this before it sees the first of them.
Q_DECLARE_METATYPE(abrazo::Annotations)
Q_DECLARE_METATYPE(abrazo::Conflict)
