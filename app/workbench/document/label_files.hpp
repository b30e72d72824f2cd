#pragma once

#include <QString>

namespace abrazo::app {

/// By its name, and for .csv and .json by how it begins: a file of labels, not of joints or takes.
bool is_label_file(const QString& file);

}  // namespace abrazo::app
