#pragma once

namespace abrazo {

/// Style sheet of reports: light and dark, wide and narrow screens, paper.
extern const char* const html_style_sheet;

}  // namespace abrazo
