#include "widgets/scene/actors/empty_culler.hpp"

#include <vtkActor.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp.h>

#include <algorithm>

namespace abrazo::widgets {

vtkStandardNewMacro(EmptyCuller);

bool draws_something(vtkProp& prop) {
  auto* actor = vtkActor::SafeDownCast(&prop);
  auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return !mapper || !mapper->GetInput() || mapper->GetInput()->GetNumberOfCells() > 0;
}

double EmptyCuller::Cull(vtkRenderer*, vtkProp** props, int& count, int& has_times) {
  vtkProp** end =
      std::stable_partition(props, props + count, [](vtkProp* prop) { return draws_something(*prop); });
  count = static_cast<int>(end - props);
  if (has_times == 0)
    for (vtkProp** prop = props; prop != end; ++prop) (*prop)->SetRenderTimeMultiplier(1);
  has_times = 1;
  return count;
}

}  // namespace abrazo::widgets
