#include "app/workbench/document/generated_fight.hpp"

#include "core/choreography/fight.hpp"
#include "core/library/build/motion_library_builder.hpp"

namespace abrazo::app {

Result<Material> make_fight(const Progress& progress) {
  report(progress, 0, "Generating a fight");
  ChoreographyOptions fight;
  fight.minutes = 1;
  auto library = build_library("generated fight", generate_fight(fight), {}, progress);
  if (!library) return library.error();
  Material material;
  material.library = std::make_shared<const MotionLibrary>(std::move(library).value());
  fight.seed = 20;
  fight.minutes = 0.5;
  fight.take_seconds = 30;
  material.input = generate_fight(fight).front().a;
  material.input.name = "generated fighter";
  return material;
}

}  // namespace abrazo::app
