#include "core/session/file/project_annotations.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "core/library/takes/tier_kind.hpp"

namespace abrazo {

namespace {

Result<TierKind> parse_kind(const std::string& text) {
  if (const auto kind = parse_tier_kind(text)) return *kind;
  return Error{"a tier is of kind '" + text + "'; there are role, move and note", {}};
}

/// Inserts of all five tables.
struct Inserts {
  SessionStatement subject, tier, word, annotation, suggestion;

  static Result<Inserts> prepare(SessionDatabase& database) {
    auto subject = database.prepare("INSERT INTO subjects (name, next_number) VALUES (?, ?)");
    auto tier = database.prepare("INSERT INTO tiers (subject, number, kind, name) VALUES (?, ?, ?, ?)");
    auto word = database.prepare(
        "INSERT INTO vocabularies (tier, value, description, rgb, key) VALUES (?, ?, ?, ?, ?)");
    auto annotation = database.prepare(
        "INSERT INTO annotations (tier, number, start_s, end_s, value, detail, confidence) "
        "VALUES (?, ?, ?, ?, ?, ?, ?)");
    auto suggestion = database.prepare(
        "INSERT INTO suggestions (tier, number, start_s, end_s, value, confidence, reason) "
        "VALUES (?, ?, ?, ?, ?, ?, ?)");
    for (const auto* one : {&subject, &tier, &word, &annotation, &suggestion})
      if (!*one) return one->error();
    return Inserts{std::move(*subject), std::move(*tier), std::move(*word), std::move(*annotation),
                   std::move(*suggestion)};
  }
};

Status write_vocabulary(Inserts& inserts, std::int64_t row, const std::vector<VocabularyEntry>& entries) {
  for (const VocabularyEntry& entry : entries) {
    SessionStatement& word = inserts.word;
    word.bind(0, row).bind(1, entry.value).bind(2, entry.description);
    entry.rgb ? word.bind(3, std::int64_t{*entry.rgb}) : word.bind_null(3);
    entry.key ? word.bind(4, std::string_view(&entry.key, 1)) : word.bind_null(4);
    if (const Status done = word.run(); !done) return done;
  }
  return Done{};
}

Status write_tier(Inserts& inserts, std::int64_t row, const AnnotationTier& tier) {
  if (const Status done = write_vocabulary(inserts, row, tier.vocabulary); !done) return done;
  for (const Annotation& one : tier.annotations) {
    SessionStatement& insert = inserts.annotation;
    insert.bind(0, row).bind(1, one.id).bind(2, one.start_s).bind(3, one.end_s).bind(4, one.value);
    insert.bind(5, one.detail).bind(6, one.confidence);
    if (const Status done = insert.run(); !done) return done;
  }
  return Done{};
}

Status write_subject(SessionDatabase& database, Inserts& inserts, const std::string& name,
                     const Annotations& annotations) {
  if (const Status done = inserts.subject.bind(0, name).bind(1, annotations.next_id()).run(); !done)
    return done;
  const std::int64_t subject = database.last_row_id();
  std::map<int, std::int64_t> rows;
  for (const AnnotationTier& tier : annotations.tiers()) {
    inserts.tier.bind(0, subject).bind(1, tier.id).bind(2, text_of(tier.kind)).bind(3, tier.name);
    if (const Status done = inserts.tier.run(); !done) return done;
    const std::int64_t row = rows[tier.id] = database.last_row_id();
    if (const Status done = write_tier(inserts, row, tier); !done) return done;
  }
  for (const Suggestion& one : annotations.suggestions()) {
    SessionStatement& insert = inserts.suggestion;
    insert.bind(0, rows[one.tier]).bind(1, one.id).bind(2, one.start_s).bind(3, one.end_s);
    insert.bind(4, one.value).bind(5, one.confidence).bind(6, one.reason);
    if (const Status done = insert.run(); !done) return done;
  }
  return Done{};
}

/// What is read of one subject, and what its further rows must not repeat.
struct Subject {
  std::string name;
  int next_id = 1;
  std::vector<AnnotationTier> tiers;
  std::vector<Suggestion> suggestions;
  std::set<int> ids;
};

class Reader {
 public:
  explicit Reader(TableReader& tables) : tables_(tables) {}

  AnnotationBook read() {
    read_subjects();
    read_tiers();
    read_vocabularies();
    read_annotations();
    read_suggestions();
    AnnotationBook book;
    for (auto& [row, subject] : subjects_) {
      auto restored =
          Annotations::restored(std::move(subject.tiers), std::move(subject.suggestions), subject.next_id);
      if (restored) book[subject.name] = std::move(*restored);
    }
    return book;
  }

 private:
  struct Place {
    std::int64_t subject;
    std::size_t tier;
  };

  Status take_id(Subject& subject, std::int64_t id) {
    if (id < 1 || id >= std::numeric_limits<int>::max())
      return Error{
          "the number " + std::to_string(id) + " is not the number of an annotation (1 to 2147483646)", {}};
    if (!subject.ids.insert(static_cast<int>(id)).second)
      return Error{"the number " + std::to_string(id) + " is used twice", {}};
    subject.next_id = std::max(subject.next_id, static_cast<int>(id) + 1);
    return Done{};
  }

  /// The subject and tier that a row belongs to.
  Result<std::pair<Subject*, AnnotationTier*>> owner(std::int64_t tier_row) {
    const auto place = tiers_.find(tier_row);
    if (place == tiers_.end()) return Error{"its tier " + std::to_string(tier_row) + " is not there", {}};
    Subject& subject = subjects_.at(place->second.subject);
    return std::pair(&subject, &subject.tiers[place->second.tier]);
  }

  void read_subjects() {
    std::set<std::string> names;
    tables_.each("annotated subjects", "subjects", "name, next_number", [&](const SessionStatement& row) {
      const std::string name = row.text(1);
      if (!names.insert(name).second) return Status(Error{"'" + name + "' is used twice", {}});
      Subject subject;
      subject.name = name;
      subject.next_id =
          static_cast<int>(std::clamp<std::int64_t>(row.integer(2), 1, std::numeric_limits<int>::max() - 1));
      subjects_[row.integer(0)] = std::move(subject);
      return Status(Done{});
    });
  }

  void read_tiers() {
    tables_.each("tiers", "tiers", "subject, number, kind, name", [&](const SessionStatement& row) -> Status {
      const auto found = subjects_.find(row.integer(1));
      if (found == subjects_.end()) return Error{"a tier belongs to nothing", {}};
      Subject& subject = found->second;
      auto kind = parse_kind(row.text(3));
      if (!kind) return kind.error();
      AnnotationTier tier{static_cast<int>(row.integer(2)), row.text(4), *kind, {}, {}};
      const auto is_same = [&](const AnnotationTier& other) { return other.name == tier.name; };
      if (tier.name.empty() || std::ranges::any_of(subject.tiers, is_same))
        return Error{"a tier has no unique name", {}};
      if (Status fresh = take_id(subject, row.integer(2)); !fresh) return fresh;
      tiers_[row.integer(0)] = {found->first, subject.tiers.size()};
      subject.tiers.push_back(std::move(tier));
      return Done{};
    });
  }

  void read_vocabularies() {
    tables_.each("words of vocabularies", "vocabularies", "tier, value, description, rgb, key",
                 [&](const SessionStatement& row) -> Status {
                   const auto tier = owner(row.integer(1));
                   if (!tier) return tier.error();
                   VocabularyEntry entry{row.text(2), row.text(3)};
                   if (!row.is_null(4)) entry.rgb = static_cast<std::uint32_t>(row.integer(4) & 0xffffff);
                   const std::string key = row.text(5);
                   if (key.size() > 1) return Error{"'" + key + "' is not one key", {}};
                   entry.key = key.empty() ? '\0' : key.front();
                   tier->second->vocabulary.push_back(std::move(entry));
                   return Done{};
                 });
  }

  void read_annotations() {
    tables_.each("annotations", "annotations", "tier, number, start_s, end_s, value, detail, confidence",
                 [&](const SessionStatement& row) -> Status {
                   const auto tier = owner(row.integer(1));
                   if (!tier) return tier.error();
                   if (Status good = check_times(row); !good) return good;
                   auto& others = tier->second->annotations;
                   if (!others.empty() && row.real(3) < others.back().end_s)
                     return Error{"'" + row.text(5) + "' begins before the one before it ends", {}};
                   if (Status fresh = take_id(*tier->first, row.integer(2)); !fresh) return fresh;
                   others.push_back({{.start_s = row.real(3),
                                      .end_s = row.real(4),
                                      .value = row.text(5),
                                      .detail = row.text(6),
                                      .confidence = row.text(7)},
                                     static_cast<int>(row.integer(2))});
                   return Done{};
                 });
  }

  void read_suggestions() {
    tables_.each(
        "suggestions", "suggestions", "tier, number, start_s, end_s, value, confidence, reason",
        [&](const SessionStatement& row) -> Status {
          const auto tier = owner(row.integer(1));
          if (!tier) return tier.error();
          if (Status good = check_times(row); !good) return good;
          if (Status good = finite(row, {6}, "a suggestion"); !good) return good;
          if (Status fresh = take_id(*tier->first, row.integer(2)); !fresh) return fresh;
          tier->first->suggestions.push_back({static_cast<int>(row.integer(2)), tier->second->id, row.real(3),
                                              row.real(4), row.text(5), row.real(6), row.text(7)});
          return Done{};
        });
  }

  static Status check_times(const SessionStatement& row) {
    if (Status good = finite(row, {3, 4}, "'" + row.text(5) + "'"); !good) return good;
    if (row.real(3) < row.real(4)) return Done{};
    return Error{"'" + row.text(5) + "' does not end after it begins", {}};
  }

  TableReader& tables_;
  std::map<std::int64_t, Subject> subjects_;  ///< by row
  std::map<std::int64_t, Place> tiers_;       ///< by row
};

}  // namespace

Status write_annotations(SessionDatabase& database, const AnnotationBook& book) {
  const Status cleared = database.execute(
      "DELETE FROM suggestions; DELETE FROM annotations; DELETE FROM vocabularies; DELETE FROM tiers; "
      "DELETE FROM subjects");
  if (!cleared) return cleared;
  auto inserts = Inserts::prepare(database);
  if (!inserts) return inserts.error();
  for (const auto& [name, annotations] : book)
    if (const Status done = write_subject(database, *inserts, name, annotations); !done) return done;
  return Done{};
}

AnnotationBook read_annotations(TableReader& tables) {
  return Reader(tables).read();
}

}  // namespace abrazo
