#include "app/workbench/document/library_feed.hpp"

#include <algorithm>
#include <utility>

#include "app/workbench/base/job.hpp"

namespace abrazo::app {
namespace {

constexpr int settle_ms = 120;

bool same(const std::vector<RoleInterval>& a, const std::vector<RoleInterval>& b) {
  return std::ranges::equal(a, b, [](const RoleInterval& x, const RoleInterval& y) {
    return x.start == y.start && x.end == y.end && x.active == y.active;
  });
}

bool same(const std::vector<LabelInterval>& a, const std::vector<LabelInterval>& b) {
  return std::ranges::equal(a, b, [](const LabelInterval& x, const LabelInterval& y) {
    return x.start == y.start && x.end == y.end && x.label == y.label && x.detail == y.detail &&
           x.confidence == y.confidence;
  });
}

bool same(const TakeAnnotation& a, const TakeAnnotation& b) {
  return same(a.roles, b.roles) && same(a.labels, b.labels);
}

const LibraryTake* take_named(const MotionLibrary& library, const std::string& name) {
  const int found = library.find_take(name);
  return found < 0 ? nullptr : &library.takes()[static_cast<std::size_t>(found)];
}

Result<PreparedSolver> annotated(Material material, const std::map<std::string, TakeAnnotation>& takes,
                                 const Settings& settings) {
  for (const auto& [take, annotation] : takes) {
    auto next = with_annotation(*material.library, take, annotation);
    if (!next) return next.error();
    material.library = std::make_shared<const MotionLibrary>(std::move(next).value());
  }
  return prepare_solver(std::move(material), settings);
}

}  // namespace

LibraryFeed::LibraryFeed(Document& document, QObject* parent) : QObject(parent), m_document(document) {
  m_soon.setSingleShot(true);
  m_soon.setInterval(settle_ms);
  connect(&m_soon, &QTimer::timeout, this, &LibraryFeed::begin);
}

LibraryFeed::~LibraryFeed() = default;

void LibraryFeed::forget() {
  m_soon.stop();
  m_wanted.clear();
  m_working.clear();
  Job::retire(std::move(m_job), this);
}

void LibraryFeed::put(const std::string& take, const Annotations& annotations) {
  if (!m_document.session()) return;
  const LibraryTake* known = take_named(*m_document.session()->material().library, take);
  if (!known) return;
  const auto said = take_annotation(annotations, known->fps, known->frames);
  if (!said)
    return emit failed(QString::fromStdString(said.error().text()) +
                       "; the library keeps the roles it has until then");
  const auto waiting = m_wanted.find(take), working = m_working.find(take);
  const TakeAnnotation in_library{known->roles, known->labels};
  const TakeAnnotation& last = waiting != m_wanted.end()    ? waiting->second
                               : working != m_working.end() ? working->second
                                                            : in_library;
  if (same(last, *said)) return;
  m_wanted[take] = *said;
  m_soon.start();
}

void LibraryFeed::begin() {
  if (!m_document.session() || m_wanted.empty()) return;
  // What the job before did not finish is included: the newest of each take.
  for (auto& [take, annotation] : m_working) m_wanted.emplace(take, annotation);
  m_working = std::move(m_wanted);
  m_wanted.clear();
  Job::retire(std::move(m_job), this);
  m_job = std::make_unique<Job>([this, material = m_document.session()->material(), takes = m_working,
                                 settings = m_document.settings()](const Progress&) -> Job::Finish {
    auto prepared = annotated(material, takes, settings);
    if (!prepared)
      return [this, why = prepared.error().text()] {
        m_working.clear();
        emit failed(QString::fromStdString(why));
      };
    auto ready = std::make_shared<PreparedSolver>(std::move(prepared).value());
    return [this, ready, base = material.library] {
      if (m_document.session()->material().library != base) return beginAgain();
      m_working.clear();
      m_document.replaceSolver(std::move(*ready));
    };
  });
}

/// The library got a take meanwhile, say, which is not in what was made.
void LibraryFeed::beginAgain() {
  for (auto& [take, annotation] : std::exchange(m_working, {})) m_wanted.emplace(take, annotation);
  begin();
}

}  // namespace abrazo::app
