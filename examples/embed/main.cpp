// Answers a dancer in a program of your own: prints where the partner's root is for every pose of the dancer.
//   embed LIBRARY.h5 MOTION.bvh
#include <cstdio>
#include <memory>

#include "core/library/store/motion_library_file.hpp"
#include "core/motion/files/import_clip.hpp"
#include "core/synthesis/step/partner_synthesizer.hpp"

int fail(const abrazo::Error& error) {
  std::fprintf(stderr, "embed: %s\n", error.text().c_str());
  return 1;
}

int main(int argc, char** argv) {
  if (argc != 3) return fail({"usage: embed LIBRARY.h5 MOTION.bvh", ""});

  auto library = abrazo::read_library(argv[1]);
  if (!library) return fail(library.error());
  auto performers = abrazo::load_motion(argv[2], "", {});
  if (!performers) return fail(performers.error());
  const abrazo::Clip& dancer = performers->front().clip;

  auto partner = abrazo::PartnerSynthesizer::create(
      std::make_shared<const abrazo::MotionLibrary>(std::move(library).value()),
      abrazo::preset("responsive").value());
  if (!partner) return fail(partner.error());
  abrazo::PartnerSynthesizer& synthesizer = **partner;
  synthesizer.set_user_body(abrazo::body_of(dancer.poses));  // without it the first pose is measured

  double before_s = 0;
  for (std::size_t frame = 0; frame < dancer.poses.size(); ++frame) {
    const double now_s = static_cast<double>(frame) / dancer.fps;  // live: your clock
    const auto& answer = synthesizer.step(dancer.poses[frame], abrazo::Duration(now_s - before_s));
    before_s = now_s;
    if (answer.status == abrazo::StepStatus::Failed) return fail({answer.message, argv[2]});
    const auto root = answer.passive().row(0);  // [m], Y up; joint 0 of 25
    std::printf("%.17g %.17g %.17g\n", root.x(), root.y(), root.z());
  }
  return 0;
}
