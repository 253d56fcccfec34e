#include "app/document/commands.h"
#include "app/workbench/fusion_page.h"
#include "widgets/curve/fusion_curve_editor.h"
#include "widgets/curve/fusion_curve_panel.h"
#include "widgets/panels/flash.h"
#include "widgets/theme/theme.h"
#include "widgets/viewport/result_pane.h"

namespace graftsman {
namespace {

void dragCurve(DocumentModel& model, const FCF& curve) {
  Fusion fusion = model.committed();
  fusion.inputs.fcf = curve;
  model.drag(std::move(fusion));
}

}  // namespace

void connectCurve(FusionCurvePanel& panel, DocumentModel& model, FusionPage& page) {
  FusionCurveEditor* editor = panel.editor();
  panel.setCurve(model.fusion().inputs.fcf);
  QObject::connect(&model, &DocumentModel::changed, &panel,
                   [&panel, &model, editor](Change change, const Touched& touched) {
                     panel.setCurve(model.fusion().inputs.fcf);
                     const auto points = static_cast<int>(model.fusion().inputs.fcf.points().size());
                     if (change == Change::History && touched.curvePoint && *touched.curvePoint < points) {
                       editor->selectPoint(*touched.curvePoint);
                       const FCFPoint& at =
                           editor->curve().points()[static_cast<std::size_t>(*touched.curvePoint)];
                       constexpr int kAround = sizes::kHitArea / 2;
                       flash(*editor, QRect(editor->position(at).toPoint() - QPoint(kAround, kAround),
                                            QSize(sizes::kHitArea, sizes::kHitArea)));
                     }
                   });
  QObject::connect(editor, &FusionCurveEditor::moved, &panel,
                   [&](int, const FCF& curve) { dragCurve(model, curve); });
  QObject::connect(editor, &FusionCurveEditor::moveFinished, &panel, [&](int point) {
    model.push(std::make_unique<MoveFCFPoint>(model, model.fusion().inputs.fcf, point));
  });
  QObject::connect(editor, &FusionCurveEditor::moveCancelled, &panel, [&] { model.cancelDrag(); });
  QObject::connect(editor, &FusionCurveEditor::pointAdded, &panel, [&](int point, const FCF& curve) {
    model.push(std::make_unique<AddFCFPoint>(model, curve, point));
  });
  QObject::connect(editor, &FusionCurveEditor::pointRemoved, &panel, [&](int point, const FCF& curve) {
    model.push(std::make_unique<RemoveFCFPoint>(model, curve, point));
  });
  QObject::connect(editor, &FusionCurveEditor::sHovered, &page,
                   [&](double s) { page.pane()->setRing(s >= 0 ? std::optional(s) : std::nullopt); });
  QObject::connect(&panel, &FusionCurvePanel::presetChosen, &panel,
                   [&](FCF::Preset preset) { model.push(std::make_unique<SetFCFPreset>(model, preset)); });
  QObject::connect(&panel, &FusionCurvePanel::monotoneChosen, &panel,
                   [&](const FCF& curve) { model.push(std::make_unique<SetFCFMonotone>(model, curve)); });
}

}  // namespace graftsman
