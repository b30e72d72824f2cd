#include "app/workbench/base/running_work.hpp"

#include <QMetaObject>
#include <QPointer>
#include <algorithm>
#include <utility>
#include <vector>

namespace abrazo::app {
namespace {

struct AllWork {
  std::vector<RunningWork*> running;
  QPointer<QObject> context;
  std::function<void()> then;

  void tellIfNone() {
    if (!running.empty() || !then) return;
    auto call = std::exchange(then, nullptr);
    if (context) QMetaObject::invokeMethod(context, std::move(call), Qt::QueuedConnection);
  }
};

AllWork& all_work() {
  static AllWork all;
  return all;
}

}  // namespace

RunningWork::RunningWork(std::function<void()> stop) : m_stop(std::move(stop)) {
  all_work().running.push_back(this);
}

RunningWork::~RunningWork() {
  std::erase(all_work().running, this);
  all_work().tellIfNone();
}

bool RunningWork::any() {
  return !all_work().running.empty();
}

void RunningWork::stopAll(QObject* context, std::function<void()> then) {
  AllWork& all = all_work();
  all.context = context;
  all.then = std::move(then);
  // To stop one may end others.
  for (RunningWork* work : std::vector(all.running))
    if (std::ranges::find(all.running, work) != all.running.end()) work->m_stop();
  all.tellIfNone();
}

}  // namespace abrazo::app
