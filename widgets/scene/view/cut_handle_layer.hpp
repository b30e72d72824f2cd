#pragma once

#include <QWidget>
#include <optional>

#include "widgets/common/palette.hpp"
#include "widgets/scene/values/cut_handles.hpp"

namespace abrazo::widgets {

/// Paints the handles of the cutting plane above the scene: no body hides them, and no picture that is saved
/// has them. Ignores the pointer.
class CutHandleLayer : public QWidget {
 public:
  explicit CutHandleLayer(QWidget* parent);
  void setColours(const Palette& palette);
  /// @param handles none: hidden  @param held  drawn stronger
  void show(const std::optional<CutHandles>& handles, CutGrip held);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Palette m_palette = palette_of(Theme::Dark);
  std::optional<CutHandles> m_handles;
  CutGrip m_held = CutGrip::None;
};

}  // namespace abrazo::widgets
