#include "widgets/plots/plot_colours.hpp"

#include <qcustomplot.h>

#include "widgets/common/theme.hpp"

namespace abrazo::widgets {

QColor colour_of(Series series, const Palette& p) {
  switch (series) {
    case Series::DeformationEnergy:
      return p.energy_deformation;
    case Series::VelocityEnergy:
      return p.energy_velocity;
    case Series::ConstraintEnergy:
      return p.energy_constraint;
    case Series::FootLock:
      return p.residual_locks;
    case Series::ExcessPenetration:
      return p.residual_penetration;
    case Series::Penetration:
      return p.text;
    case Series::MorphRms:
      return p.active;
    case Series::BoneLength:
      return p.residual_bones;
    case Series::PoseCost:
      return p.user;
    case Series::LeaderCost:
      return p.active;
    case Series::FollowerCost:
      return p.passive;
    case Series::TotalCost:
      return p.text;
    case Series::CostMargin:
      return p.residual_penetration;
    case Series::ExpectedPartner:
      return p.passive;
    case Series::LeaderMotion:
      return p.active;
    case Series::UnlikelyMove:
      return p.residual_penetration;
    case Series::NotMeant:
      return p.warning;
    case Series::ChangeOfSource:
      return p.user;
    case Series::IntentTotal:
      return p.text;
    case Series::IntentMargin:
      return p.energy_velocity;
    case Series::RetargetTime:
      return p.user;
    case Series::SelectTime:
      return p.residual_bones;
    case Series::MeshTime:
      return p.residual_penetration;
    case Series::SolveTime:
      return p.energy_velocity;
    case Series::TotalTime:
      return p.text;
    case Series::HoldChange:
      return p.energy_constraint;
    case Series::PartnerStep:
      return p.energy_velocity;
    case Series::BehindSelected:
      return p.user;
    case Series::SourceChanges:
      return p.residual_bones;
    case Series::PartnerSpeed:
    case Series::PartnerAcceleration:
      return p.passive;
    case Series::RecordedSpeed:
    case Series::RecordedAcceleration:
      return p.ghost_passive;
    case Series::FootSlide:
      return p.residual_bones;
    case Series::JointResidual:
      return p.energy_constraint;
    case Series::JointFromUser:
      return p.user;
    case Series::JointFromSelected:
      return p.ghost_passive;
    case Series::JointSpeed:
      return p.energy_velocity;
    case Series::EdgeLength:
      return p.text;
    case Series::EdgeReference:
      return p.ghost_active;
    case Series::EdgeResidual:
      return p.residual_penetration;
    case Series::EdgeWeight:
      return p.energy_velocity;
    case Series::CellRatio:
      return p.residual_penetration;
  }
  return p.text;
}

bool is_dashed(Series series) {
  return series == Series::TotalCost || series == Series::IntentTotal || series == Series::TotalTime ||
         series == Series::EdgeReference;
}

void set_frame_colours(QCustomPlot& plot, const Palette& palette) {
  plot.setBackground(QBrush(palette.panel));
  const QColor faint = mixed(palette.secondary, palette.panel, 0.22);
  for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
    axis->setBasePen(QPen(faint));
    axis->setTickPen(Qt::NoPen);
    axis->setSubTickPen(Qt::NoPen);
    axis->setTickLabelColor(palette.secondary);
    axis->setTickLabelFont(interface_font(10));
    axis->setLabelColor(palette.secondary);
    axis->setLabelFont(interface_font(10));
    axis->grid()->setPen(QPen(faint, 1));
    axis->grid()->setZeroLinePen(QPen(faint, 1));
  }
  plot.xAxis->grid()->setVisible(false);
}

}  // namespace abrazo::widgets
