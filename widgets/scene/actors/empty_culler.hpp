#pragma once

#include <vtkCuller.h>

namespace abrazo::widgets {

/// False for an actor without cells.
bool draws_something(vtkProp& prop);

/// Leaves out what has nothing to draw: VTK complains of an actor without cells when it measures its time.
/// VTK's own culler leaves out what is outside of the picture, which in this scene is hardly ever the case,
/// and needs the bounds of all points with every picture.
class EmptyCuller : public vtkCuller {
 public:
  vtkTypeMacro(EmptyCuller, vtkCuller) static EmptyCuller* New();

  double Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& has_times) override;
};

}  // namespace abrazo::widgets
