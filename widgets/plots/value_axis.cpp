#include "widgets/plots/value_axis.hpp"

#include <algorithm>

namespace abrazo::widgets {
namespace {

constexpr double nothing = 1e-6;  // in any unit: below it is what rounding leaves

}  // namespace

void ValueAxis::include(double above, double below, double least_reach) {
  if (m_isSettled) m_needs = {};
  m_isSettled = false;
  m_needs.above = std::max(m_needs.above, above);
  m_needs.below = std::max(m_needs.below, below);
  m_needs.least_reach = std::max({m_needs.least_reach, least_reach, nothing});
}

void ValueAxis::settle(double time_s) {
  m_isSettled = true;
  m_above.show(m_needs.above, time_s);
  m_below.show(m_needs.below, time_s);
}

void ValueAxis::forget() {
  m_above.reset();
  m_below.reset();
}

double ValueAxis::upper() const {
  // A recorded take is not solved, all its costs are 0: an axis to 1 has numbers that can be read.
  if (m_above.upper() < nothing && m_needs.below < nothing) return 1;
  return std::max(m_above.upper(), m_needs.least_reach);
}

}  // namespace abrazo::widgets
