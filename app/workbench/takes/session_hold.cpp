#include "app/workbench/takes/session_hold.hpp"

#include <QFileInfo>
#include <QRegularExpression>

namespace abrazo::app {
namespace {

/// One for all names that lead to the file.
QString lock_file_of(const QString& session) {
  const QFileInfo file(session);
  const QFileInfo real(file.exists() ? file.canonicalFilePath() : file.absoluteFilePath());
  return real.path() + "/." + real.fileName() + ".lock";
}

/// What a stranger put there instead, such as a pipe, is not opened.
bool can_be_a_lock(const QString& path) {
  const QFileInfo there(path);
  return !there.isSymLink() && (!there.exists() || there.isFile());
}

}  // namespace

bool SessionHold::take(const QString& session) {
  if (m_lock && m_session == session) return true;
  release();
  m_session = session;
  const QString path = lock_file_of(session);
  if (session.isEmpty() || !can_be_a_lock(path)) return true;
  auto lock = std::make_unique<QLockFile>(path);
  lock->setStaleLockTime(0);  // a session may be open for days
  if (lock->tryLock(0)) {
    m_lock = std::move(lock);
  } else if (lock->error() == QLockFile::LockFailedError) {
    qint64 process = 0;
    QString host, program;
    lock->getLockInfo(&process, &host, &program);
    static const QRegularExpression unusual("[^\\w.-]");  // anybody can write the file
    m_holder = QString("process %1 on %2").arg(process).arg(host.left(60).remove(unusual));
  }
  return m_holder.isEmpty();
}

void SessionHold::release() {
  m_lock.reset();
  m_session.clear();
  m_holder.clear();
}

}  // namespace abrazo::app
