#include "widgets/scene/actors/comparison_ghost.hpp"

#include <QColor>
#include <vector>

#include "widgets/scene/values/comparison_dashes.hpp"

namespace abrazo::widgets {
namespace {

constexpr double least_difference_m = 0.02;  // below, a line is only clutter
constexpr double before_rim_m = 0.004;

/// Two points a line, in order.
void set_strokes(LineSet& lines, const std::vector<double>& ends) {
  std::vector<std::array<int, 2>> pairs;
  for (int p = 0; p + 1 < static_cast<int>(ends.size() / 3); p += 2) pairs.push_back({p, p + 1});
  lines.setPoints(ends);
  lines.setLines(pairs);
}

}  // namespace

ComparisonGhost::ComparisonGhost() {
  applyVisibility();
}

void ComparisonGhost::addTo(vtkRenderer* in_front) {
  m_differences.addTo(in_front);
  for (Run* run : {&m_a, &m_b})
    for (std::size_t body = 0; body < 2; ++body) {
      run->rims[body].addTo(in_front);
      run->bodies[body].addTo(in_front);
    }
}

void ComparisonGhost::setColours(const Palette& palette, double pixel_ratio) {
  const QColor hues[] = {palette.active, palette.passive};
  for (Run* run : {&m_a, &m_b})
    for (std::size_t body = 0; body < 2; ++body) {
      // Lighter than a body behind it, with a rim for separation.
      run->bodies[body].setColour(palette.dark ? hues[body].lighter(128) : hues[body].darker(135));
      run->bodies[body].setWidth((run == &m_a ? 3.6 : 2.8) * pixel_ratio);
      run->rims[body].setColour(palette.dark ? QColor("#0b0d10") : QColor("#ffffff"), 0.75);
      run->rims[body].setWidth(6.2 * pixel_ratio);
    }
  m_differences.setColour(palette.text, 0.7);
  m_differences.setWidth(1.2 * pixel_ratio);
}

/// A line and its wider rim are at the same depth, of which only rounding would be left.
void ComparisonGhost::separateFor(const Vec3& direction) {
  for (Run* run : {&m_a, &m_b})
    for (LineSet& body : run->bodies) body.setOffset(-before_rim_m * direction);
}

void ComparisonGhost::setVisible(bool visible) {
  m_isVisible = visible;
  applyVisibility();
}

void ComparisonGhost::applyVisibility() {
  for (Run* run : {&m_a, &m_b})
    for (std::size_t body = 0; body < 2; ++body) {
      run->rims[body].setVisible(m_isVisible && run->is_there[body]);
      run->bodies[body].setVisible(m_isVisible && run->is_there[body]);
    }
  m_differences.setVisible(m_isVisible && isThere());
}

bool ComparisonGhost::isThere() const {
  return m_a.is_there[0] || m_a.is_there[1] || m_b.is_there[0] || m_b.is_there[1];
}

void ComparisonGhost::show(const PairPose& recorded, const std::optional<PairPose>& a,
                           const std::optional<PairPose>& b) {
  const auto show_run = [&recorded](Run& run, const std::optional<PairPose>& pair, bool dashed) {
    run.is_there = {};
    for (std::size_t body = 0; pair && body < 2; ++body) {
      run.is_there[body] =
          !difference_strokes(*pair, recorded, static_cast<int>(body) * joint_count, least_difference_m)
               .empty();
      const auto strokes = bone_strokes(*pair, static_cast<int>(body) * joint_count, dashed);
      set_strokes(run.rims[body], strokes);
      set_strokes(run.bodies[body], strokes);
    }
  };
  show_run(m_a, a, true);
  show_run(m_b, b, false);
  const PairPose &from = a ? *a : recorded, &to = b ? *b : recorded;
  std::vector<double> apart;
  for (const int first : {0, joint_count})
    for (const double value : difference_strokes(from, to, first, least_difference_m)) apart.push_back(value);
  set_strokes(m_differences, apart);
  applyVisibility();
}

}  // namespace abrazo::widgets
