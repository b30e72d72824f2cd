#include "core/synthesis/frames/frame_result.hpp"

namespace abrazo {

std::string FrameResult::status_text() const {
  switch (status) {
    case StepStatus::Ok:
      return "ok";
    case StepStatus::Relaxed:
      return "relaxed: " + message;
    case StepStatus::Failed:
      break;
  }
  return "failed: " + message;
}

}  // namespace abrazo
