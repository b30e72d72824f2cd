#include <fmt/format.h>

#include "core/base/atomic_file.hpp"
#include "core/library/takes/csv_text.hpp"
#include "core/library/takes/tier_file.hpp"
#include "core/session/export/export_parts.hpp"
#include "core/session/export/session_tiers.hpp"

namespace abrazo {

namespace {

/// A label file counts frames from the beginning of each take; all others have the tiers in seconds.
Result<TierText> label_text(const SessionRecord& session, const std::vector<Tier>& tiers,
                            const SessionRange& range, const ExportWish& wish) {
  if (wish.is_label_file()) return session_labels_csv(session, range, wish.rate_hz);
  const SessionContents& contents = session.contents();
  TierWriting writing;
  writing.author = contents.program;
  if (!contents.runs.empty()) writing.date = contents.runs.front().begun_at;
  return write_tiers(tiers, wish.output, writing);
}

}  // namespace

Result<ExportReport> export_labels(const ExportSource& source, const ExportWish& wish,
                                   const Progress& progress) {
  const SessionRecord& session = source.record();
  const auto range = session_range(session, wish.part);
  if (!range) return range.error();
  if (!report(progress, 0.3, "Looking through the labels")) return cancelled(session);
  const auto tiers = source.tiers(*range);
  if (!tiers) return tiers.error();
  const auto content = label_text(session, *tiers, *range, wish);
  if (!content) return content.error();
  if (!report(progress, 0.9, "Writing")) return cancelled(session);
  if (const Status written = write_whole_file(wish.output, content->text); !written) return written.error();
  ExportReport done;
  done.files = {wish.output};
  for (const std::string& warning : content->warnings)
    done.warnings.push_back({wish.output + ": " + warning});
  write_range(done.figures, *range);
  done.figures.key("tiers").begin_array();
  for (const Tier& tier : *tiers) {
    done.text += fmt::format("{}{} {}", done.text.empty() ? "" : ", ", tier.intervals.size(), tier.name);
    done.figures.begin_object().key("name").value(tier.name);
    done.figures.key("intervals").value(static_cast<long long>(tier.intervals.size())).end_object();
  }
  done.figures.end_array();
  if (wish.is_label_file()) {
    const auto rows = parse_csv(content->text, wish.output);
    if (!rows) return rows.error();
    const std::size_t lines = rows->size() - 1;
    done.text = fmt::format("{} moves", lines);
    done.figures.key("moves").value(static_cast<long long>(lines));
  }
  return done;
}

}  // namespace abrazo
