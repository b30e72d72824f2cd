#pragma once

#include <QLockFile>
#include <QString>
#include <memory>

namespace abrazo::app {

/// The right of one window to change a session file. Others see it in a lock file beside the session. It ends
/// with the process, also when that is killed.
class SessionHold {
 public:
  /// Asks for the right to a file, and gives up that to another one. Where no lock file can be written, as in
  /// a folder that is write-protected, nothing is held and nobody is kept away.
  /// @return false if another window has it
  bool take(const QString& session);
  /// Whether another window had it when it was asked for last.
  bool isOfAnother() const { return !m_holder.isEmpty(); }
  /// Who had it then: "process 12 on pc7"; empty if nobody else.
  const QString& holder() const { return m_holder; }
  void release();

 private:
  std::unique_ptr<QLockFile> m_lock;
  QString m_session, m_holder;
};

}  // namespace abrazo::app
