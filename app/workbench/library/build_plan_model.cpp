#include "app/workbench/library/build_plan_model.hpp"

#include <QBrush>
#include <QFont>
#include <algorithm>
#include <array>
#include <cmath>

#include "app/workbench/base/error_words.hpp"
#include "widgets/common/icons.hpp"
#include "widgets/common/plain_text.hpp"
#include "widgets/common/theme.hpp"

namespace abrazo::app {
namespace {

constexpr double smallest_m = 1.0, tallest_m = 2.3;

QString cell_text(const std::string& text) {
  return QString::fromStdString(text);
}

QString unit_name(double metres) {
  constexpr std::array<std::pair<double, const char*>, 4> known = {
      {{1, "m"}, {0.01, "cm"}, {0.001, "mm"}, {0.0254, "inch"}}};
  for (const auto& [unit, name] : known)
    if (std::abs(metres - unit) < 1e-9) return name;
  return QString("%1 m").arg(metres, 0, 'g', 4);
}

QString role_name(PlannedRole role) {
  return role == PlannedRole::Leads ? "leads" : role == PlannedRole::Follows ? "follows" : "either";
}

QString confidence_name(Confidence confidence) {
  return confidence == Confidence::Sure ? "sure" : confidence == Confidence::Likely ? "likely" : "unsure";
}

}  // namespace

BuildPlanModel::BuildPlanModel(QObject* parent)
    : QAbstractTableModel(parent),
      m_remarks(remarks_on(m_plan)),
      m_palette(widgets::palette_of(widgets::Theme::Dark)) {}

bool BuildPlanModel::canBuild() const {
  return m_remarks.empty() || m_remarks.front().kind != PlanRemark::Kind::Obstacle;
}

void BuildPlanModel::setColours(const widgets::Palette& palette) {
  m_palette = palette;
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

void BuildPlanModel::refresh() {
  m_remarks = remarks_on(m_plan);
  m_shaded.clear();
  for (int row = 0; row < rowCount(); ++row) {
    const bool same_take =
        row > 0 && !performer(row).take.empty() && performer(row).take == performer(row - 1).take;
    m_shaded.push_back(row > 0 && (same_take ? m_shaded.back() : !m_shaded.back()));
  }
}

void BuildPlanModel::change(const std::function<void()>& edit) {
  edit();
  refresh();
  if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
  emit planChanged();
}

/// The same performers as before, so they keep their rows.
bool BuildPlanModel::isKnown(const std::vector<PlannedPerformer>& of_one_file) const {
  const auto same = std::count_if(m_plan.performers.begin(), m_plan.performers.end(),
                                  [&](const PlannedPerformer& performer) {
                                    return performer.source.motion == of_one_file.front().source.motion;
                                  });
  return same == static_cast<std::ptrdiff_t>(of_one_file.size());
}

void BuildPlanModel::readAnew(const std::vector<PlannedPerformer>& of_one_file) {
  for (PlannedPerformer& before : m_plan.performers)
    for (PlannedPerformer now : of_one_file) {
      if (before.source.motion != now.source.motion) continue;
      if (before.source.index.value_or(0) != now.source.index.value_or(0)) continue;
      now.take = before.take, now.role = before.role, now.guess = before.guess;
      now.source.start = before.source.start;
      before = std::move(now);
      break;
    }
}

void BuildPlanModel::replace(const std::vector<PlannedPerformer>& of_one_file) {
  const auto is_of_file = [&](const PlannedPerformer& performer) {
    return performer.source.motion == of_one_file.front().source.motion;
  };
  auto& all = m_plan.performers;
  all.erase(std::remove_if(all.begin(), all.end(), is_of_file), all.end());
  all.insert(all.end(), of_one_file.begin(), of_one_file.end());
}

void BuildPlanModel::setSurveyed(const std::vector<std::vector<PlannedPerformer>>& files) {
  const auto known = [this](const auto& file) { return isKnown(file); };
  if (std::all_of(files.begin(), files.end(), known))
    return change([&] {
      for (const auto& file : files) readAnew(file);
    });
  beginResetModel();
  for (const auto& file : files) isKnown(file) ? readAnew(file) : replace(file);
  refresh();
  endResetModel();
  emit planChanged();
}

void BuildPlanModel::pairUp() {
  beginResetModel();
  pair_up(m_plan);
  if (!m_plan.labels.empty()) name_like_labels(m_plan);
  refresh();
  endResetModel();
  emit planChanged();
}

void BuildPlanModel::setTake(const std::vector<int>& rows, const QString& take) {
  change([&] {
    for (const int row : rows) set_take(m_plan, row, take.trimmed().toStdString());
  });
}

void BuildPlanModel::setRole(const std::vector<int>& rows, PlannedRole role) {
  change([&] {
    // Of a pair that is chosen whole, the first is meant.
    for (auto row = rows.rbegin(); row != rows.rend(); ++row) set_role(m_plan, *row, role);
  });
}

void BuildPlanModel::setStart(const std::vector<int>& rows, int frame) {
  change([&] {
    for (const int row : rows) m_plan.performers[static_cast<std::size_t>(row)].source.start = frame;
  });
}

void BuildPlanModel::setName(const QString& name) {
  change([&] { m_plan.name = name.trimmed().toStdString(); });
}

void BuildPlanModel::setLabels(const QString& file, std::vector<std::string> takes) {
  change([&] {
    m_plan.labels = file.toStdString();
    m_plan.labelled_takes = std::move(takes);
    if (!file.isEmpty()) name_like_labels(m_plan);
  });
}

int BuildPlanModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_plan.performers.size());
}

int BuildPlanModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString BuildPlanModel::text(int row, int column) const {
  const PlannedPerformer& one = performer(row);
  if (column == Take) return one.take.empty() ? "not used" : cell_text(one.take);
  if (column == Performer) {
    const QString file = cell_text(one.source.motion.filename().string());
    return one.in_the_file > 1 ? file + " · " + cell_text(one.name) : file;
  }
  if (!one.clip) return column == Frames ? "cannot be read" : "";
  const ImportReport& report = one.report;
  switch (column) {
    case Role:
      return one.take.empty() ? "" : role_name(one.role);
    case Frames: {
      const int used = used_frames(m_plan, row);
      if (used == 0 || used == one.frames()) return QString::number(one.frames());
      return QString("%1–%2 of %3").arg(one.source.start).arg(one.source.start + used - 1).arg(one.frames());
    }
    case Rate:
      return QString("%1 fps").arg(report.fps, 0, 'g', 5);
    case Unit:
      return unit_name(report.metres_per_unit);
    case Height:
      return QString("%1 m").arg(report.height_m, 0, 'f', 2);
    case Up:
      return QString::fromStdString(axis_label(report.up_axis));
    case Joints:
      return cell_text(report.joint_map);
    case Pairing:
      return one.take.empty() ? "" : one.guess ? confidence_name(one.guess->confidence()) : "by hand";
    default:
      return {};
  }
}

bool BuildPlanModel::isGuess(int row, int column) const {
  const PlannedPerformer& one = performer(row);
  if (!one.clip) return false;
  return (column == Rate && one.report.fps_guessed) || (column == Unit && one.report.unit_guessed) ||
         (column == Up && one.report.up_axis_guessed) || (column == Take && one.guess) ||
         (column == Joints && one.source.joint_map.empty());
}

bool BuildPlanModel::isTrouble(int row, int column) const {
  const PlannedPerformer& one = performer(row);
  if (column == Frames && !one.clip) return true;
  if (column == Height && one.clip)
    return one.report.height_m < smallest_m || one.report.height_m > tallest_m;
  if (column == Pairing && one.guess) return one.guess->confidence() == Confidence::Unsure;
  return column == Take && std::any_of(m_remarks.begin(), m_remarks.end(), [&](const PlanRemark& remark) {
           return remark.kind == PlanRemark::Kind::Obstacle && remark.performer == row;
         });
}

QString BuildPlanModel::tip(int row, int column) const {
  const PlannedPerformer& one = performer(row);
  if (one.trouble) return cell_text(one.trouble->text(window_words));
  if (column == Performer) {
    QString words = cell_text(one.source.motion.string());
    if (!one.source.skeleton.empty()) words += "\nskeleton " + cell_text(one.source.skeleton.string());
    return words;
  }
  if ((column == Pairing || column == Take) && one.guess) return "Guessed: " + cell_text(one.guess->reason);
  if (column == Role) return "Who is active. “either”: both assignments are kept, and the library doubles";
  if (column == Height) return "Height of the head joint while standing; 1 to 2.3 m for a person";
  if (isGuess(row, column)) return "Detected from the motion; change it below";
  return {};
}

QVariant BuildPlanModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const int row = index.row(), column = index.column();
  const bool trouble = isTrouble(row, column), guess = isGuess(row, column);
  if (role == Qt::EditRole && column == Take) return cell_text(performer(row).take);
  if (role == Qt::DisplayRole)
    return text(row, column) + (guess && column != Take && column != Joints ? " ?" : "");
  if (role == Qt::ToolTipRole) return widgets::plain_tip(tip(row, column));
  if (role == Qt::AccessibleTextRole)
    return text(row, column) + (guess ? ", guessed" : "") + (trouble ? ", check this" : "");
  if (role == Qt::ForegroundRole) {
    if (trouble) return QBrush(m_palette.warning);
    const bool unused = performer(row).take.empty() && column != Performer;
    return QBrush(unused || (guess && column != Take) ? m_palette.secondary : m_palette.text);
  }
  if (role == Qt::BackgroundRole && m_shaded[static_cast<std::size_t>(row)])
    return QBrush(widgets::mixed(m_palette.raised, m_palette.panel, 0.7));
  if (role == Qt::DecorationRole && trouble) return widgets::icon(widgets::Icon::Warning, m_palette.warning);
  if (role == Qt::FontRole && column == Take && !performer(row).take.empty())
    return widgets::interface_font(13, QFont::DemiBold);
  return {};
}

bool BuildPlanModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::EditRole || index.column() != Take) return false;
  setTake({index.row()}, value.toString());
  return true;
}

QVariant BuildPlanModel::headerData(int section, Qt::Orientation orientation, int role) const {
  constexpr std::array<const char*, ColumnCount> names = {"Take", "Performer", "Role", "Frames", "Rate",
                                                          "Unit", "Height",    "Up",   "Joints", "Pairing"};
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  return QString(names[static_cast<std::size_t>(section)]);
}

Qt::ItemFlags BuildPlanModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags usual = QAbstractTableModel::flags(index);
  return index.column() == Take ? usual | Qt::ItemIsEditable : usual;
}

}  // namespace abrazo::app
