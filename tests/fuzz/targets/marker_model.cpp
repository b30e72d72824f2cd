#include "core/motion/joints/marker_model.hpp"

#include "tests/fuzz/fuzz_target.hpp"

namespace fuzz = abrazo::fuzz;

ABRAZO_FUZZ_TARGET(marker_model)(fuzz::Bytes bytes) {
  (void)abrazo::is_marker_model(fuzz::text_of(bytes));
  const auto model = abrazo::parse_marker_model(fuzz::text_of(bytes), "model.json");
  if (!fuzz::accepted(model)) return;
  const auto again = abrazo::parse_marker_model(abrazo::marker_model_json(*model), "again.json");
  fuzz::expect(again.ok() && again->names == model->names, "what was written of a model reads otherwise");
  abrazo::NamedMotion motion;
  for (const auto& both : model->names)
    for (const auto& names : both)
      if (!names.empty()) motion.points.push_back(names.front());
  motion.parents.assign(motion.points.size(), -1);
  for (int f = 0; f < 3; ++f)
    motion.frames.push_back(abrazo::Positions::Random(static_cast<Eigen::Index>(motion.points.size()), 3));
  const abrazo::MarkerFit fit = abrazo::fit_of(*model, motion.points);
  if (!fit.missing.empty()) return (void)abrazo::why_no_body(fit);
  (void)abrazo::unit_of_markers(*model, motion);
  (void)fuzz::accepted(abrazo::joints_of_markers(*model, motion, 1.0));
}
