#include "app/workbench/document/library_feed.hpp"

#include <utility>

#include "app/workbench/base/error_words.hpp"
#include "app/workbench/base/job.hpp"
#include "widgets/common/utf8.hpp"

namespace abrazo::app {
namespace {

using widgets::text;

constexpr int settle_ms = 120;

Result<PreparedSolver> annotated(Material material, const TakeAnnotations& updates,
                                 const Settings& settings) {
  const auto base = material.library_of_files();
  auto library = with_updates(base, *material.library, updates);
  if (!library) return library.error();
  material.unannotated = *library == base ? nullptr : base;
  material.library = std::move(*library);
  return prepare_solver(std::move(material), settings);
}

}  // namespace

LibraryFeed::LibraryFeed(Document& document, QObject* parent) : QObject(parent), m_document(document) {
  m_soon.setSingleShot(true);
  m_soon.setInterval(settle_ms);
  connect(&m_soon, &QTimer::timeout, this, &LibraryFeed::begin);
  connect(&document, &Document::ending, this, &LibraryFeed::forget);
  connect(&document, &Document::annotated, this, &LibraryFeed::put);
  connect(&document, &Document::opened, this, [this] {
    for (const auto& [subject, annotations] : m_document.live().annotations().all()) put(subject);
  });
}

LibraryFeed::~LibraryFeed() = default;

void LibraryFeed::forget() {
  m_soon.stop();
  m_updates.forget();
  Job::retire(std::move(m_job), this);
}

void LibraryFeed::put(const std::string& take) {
  if (take.empty() || !m_document.session()) return;
  const auto waits = m_updates.put(*m_document.session()->material().library, take,
                                   m_document.live().annotations().of(take));
  if (!waits) return emit failed(words(waits.error()) + "; the library keeps the roles it has until then");
  if (*waits) m_soon.start();
}

void LibraryFeed::begin() {
  if (!m_document.session() || m_updates.is_idle()) return;
  Job::retire(std::move(m_job), this);
  m_job = std::make_unique<Job>([this, material = m_document.session()->material(), takes = m_updates.begin(),
                                 settings = m_document.settings()](const Progress&) -> Job::Finish {
    auto prepared = annotated(material, takes, settings);
    if (!prepared)
      return [this, why = prepared.error().text()] {
        m_updates.end();
        emit failed(text(why));
      };
    auto ready = std::make_shared<PreparedSolver>(std::move(prepared).value());
    return [this, ready, base = material.library] {
      // The library changed meanwhile (e.g. got a take), so the result is outdated.
      if (m_document.session()->material().library != base) return begin();
      m_updates.end();
      m_document.replaceSolver(std::move(*ready));
    };
  });
}

}  // namespace abrazo::app
