#include "app/workbench/compare/sweep_run.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "app/workbench/base/range_words.hpp"
#include "core/evaluation/run/library_data.hpp"
#include "widgets/common/message_bar.hpp"

namespace abrazo::app {
namespace {

using widgets::SweepCell;
using widgets::SweepGoal;
using widgets::SweepGrid;
using widgets::SweepSide;

constexpr double highest_rate_hz = 120;
constexpr int yielding = 15;  ///< nice value, of 19 steps

/// This thread and those it starts work when the picture and the live solver do not.
void stand_back() {
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), yielding);
}

SweepSide side_of(const SweepAxis& axis) {
  const SettingInfo& info = *find_setting(axis.key);
  const std::string title(info.symbol.empty() ? info.title : info.symbol);
  return {axis.key, title, std::string(info.unit), axis.values};
}

SweepGoal shown_goal(const std::string& metric) {
  switch (goal_of(metric)) {
    case FigureGoal::Highest:
      return SweepGoal::Highest;
    case FigureGoal::NearestZero:
      return SweepGoal::NearestZero;
    case FigureGoal::Lowest:
    case FigureGoal::None:
      break;
  }
  return SweepGoal::Lowest;
}

}  // namespace

SweepRun::SweepRun(QObject* parent) : QObject(parent) {}

SweepRun::~SweepRun() {
  if (running()) end({});
  qDeleteAll(findChildren<Job*>());  // they speak to this object until they have noticed
}

void SweepRun::setLibrary(std::shared_ptr<const MotionLibrary> library) {
  if (library == m_library) return;
  if (running()) end("The library was replaced; the sweep has ended.");
  m_library = std::move(library);
  m_data.reset();
}

Result<Sweep> SweepRun::sweepOf(const widgets::SweepRequest& request, const Settings& settings) const {
  if (!m_library) return Error{"open a library first", "sweep"};
  const auto x = parse_sweep_axis(request.x), y = parse_sweep_axis(request.y);
  if (!x) return x.error();
  if (!y) return y.error();
  Sweep sweep{.data = fmt::format("{} ({} pairs)", m_library->name(), m_library->pair_count()),
              .settings = settings,
              .x = *x,
              .y = *y,
              .metric = request.metric};
  for (std::size_t i = 0; i < request.takes.size(); ++i)
    sweep.data += (i == 0 ? ", answered " : " ") + request.takes[i];
  if (x->key == y->key) return Error{"choose two different settings", x->key};
  if (const Status usable = check_sweep(sweep); !usable) return usable.error();
  if (m_library->takes().size() < 2)
    return Error{"a take is answered by the others, so at least two are needed; open a larger library",
                 m_library->name()};
  return sweep;
}

double SweepRun::stepsOf(const Sweep& sweep, const std::vector<std::string>& takes) const {
  double steps = 0;
  for (int point = 0; point < point_count(sweep); ++point) {
    const Settings settings = settings_at(sweep, point);
    for (const LibraryTake& take : m_library->takes()) {
      if (!takes.empty() && std::find(takes.begin(), takes.end(), take.name) == takes.end()) continue;
      const double own_hz = std::min(highest_rate_hz, take.fps / std::max(1, take.frame_stride));
      const double rate_hz = settings.step_rate_hz > 0 ? std::min(own_hz, settings.step_rate_hz) : own_hz;
      steps += take.frames / take.fps * rate_hz;
    }
  }
  return steps;
}

void SweepRun::start(const Sweep& sweep, const std::vector<std::string>& takes) {
  cancel();
  m_sweep = sweep;
  m_grid = SweepGrid(side_of(sweep.x), side_of(sweep.y), sweep.metric, shown_goal(sweep.metric));
  m_figures.assign(static_cast<std::size_t>(point_count(sweep)), {});
  m_clock.start();
  const int run = ++m_run;
  m_job = std::make_unique<Job>([this, run, sweep, takes, library = m_library,
                                 data = m_data](const Progress& progress) mutable -> Job::Finish {
    stand_back();
    report(progress, 0, "collecting the takes");
    if (!data) {
      auto gathered = evaluation_data_of(library);
      if (!gathered) return [this, text = words(gathered.error())] { end(text); };
      data = std::make_shared<const EvaluationData>(std::move(*gathered));
    }
    const auto evaluator = [&](const Settings& at, const Progress& within) {
      return evaluate(*data, {.parts = sweep_parts(), .settings = at, .hold_out = takes, .variants = false},
                      within);
    };
    const auto hand_over = [&](int point, const Result<Figures>& figures) {
      QMetaObject::invokeMethod(this, [this, run, point, figures] { take(run, point, figures); });
      return true;
    };
    const Status done = evaluate_points(sweep, coarse_first(sweep), evaluator, hand_over, progress);
    return [this, data, text = done ? QString("Done.") : words(done.error())] {
      m_data = data;
      end(text);
    };
  });
  connect(m_job.get(), &Job::progressed, this, [this](double fraction, const QString& doing) {
    const int done = m_grid.points() - m_grid.count(SweepCell::State::Waiting);
    emit progressed(fraction,
                    done == 0
                        ? doing
                        : QString("%1 of %2 cells%3").arg(done).arg(m_grid.points()).arg(timeLeft(fraction)));
  });
  emit gridChanged();
}

QString SweepRun::timeLeft(double fraction) const {
  if (!(fraction > 0)) return {};
  return ", " + about(0.001 * static_cast<double>(m_clock.elapsed()) * (1 - fraction) / fraction) + " left";
}

void SweepRun::take(int run, int point, const Result<Figures>& figures) {
  if (run != m_run) return;
  if (figures) {
    m_figures[static_cast<std::size_t>(point)] = *figures;
    fill(point);
  } else {
    m_grid.set(point, {SweepCell::State::Failed, 0, figures.error().text()});
  }
  emit gridChanged();
}

void SweepRun::fill(int point) {
  const Figures& figures = m_figures[static_cast<std::size_t>(point)];
  if (figures.empty()) return;
  const auto found = figures.find(m_sweep.metric);
  if (found == figures.end())
    m_grid.set(point, {SweepCell::State::Undefined, 0, {}});
  else
    m_grid.set(point, {SweepCell::State::Measured, found->second, {}});
}

void SweepRun::setMetric(const std::string& metric) {
  if (m_grid.empty() || metric == m_sweep.metric || !check_metric(metric)) return;
  m_sweep.metric = metric;
  m_grid.set_metric(metric, shown_goal(metric));
  for (int point = 0; point < m_grid.points(); ++point) fill(point);
  emit gridChanged();
}

void SweepRun::cancel() {
  if (running()) end("Cancelled; the results so far stay.");
}

void SweepRun::end(const QString& words) {
  ++m_run;
  // Called from within the job's last signal, or before it has noticed: either way it goes by itself.
  if (m_job) m_job->disconnect(this);
  Job::retire(std::move(m_job), this);
  emit ended(words);
}

void tell_progress(SweepRun& run, widgets::MessageBar& messages) {
  QObject::connect(&run, &SweepRun::progressed, &messages, [&messages](double fraction, const QString&) {
    messages.showProgress("Sweeping two settings", fraction);
  });
  QObject::connect(&messages, &widgets::MessageBar::cancelRequested, &run, &SweepRun::cancel);
  QObject::connect(&run, &SweepRun::ended, &messages, [&messages](const QString& words) {
    messages.endProgress();
    if (!words.isEmpty()) messages.showInformation("Sweep: " + words);
  });
}

}  // namespace abrazo::app
