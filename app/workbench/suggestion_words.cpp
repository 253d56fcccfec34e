#include "app/workbench/suggestion_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <cmath>
#include <numbers>

#include "app/document/commands.h"
#include "widgets/panels/numbers.h"

namespace graftsman {
namespace {

QString suggested(const char* text) {
  return QCoreApplication::translate("graftsman::Suggester", text);
}

QString degrees(double radians) {
  return QLocale().toString(radians * 180 / std::numbers::pi, 'f', 1);
}

QString curveText(const FCF& before, const Suggestion& suggestion) {
  const FCF& after = suggestion.inputs.fcf;
  QString monotone = after.monotone() ? suggested("monotone") : suggested("not monotone");
  if (after.points() == before.points()) {
    return monotone;
  }
  QString name = suggestion.preset ? label(*suggestion.preset) : suggested("the curve");
  if (suggestion.height != 1) {
    name = suggested("%1 at %2 %").arg(name).arg(std::lround(100 * suggestion.height));
  }
  return after.monotone() ? name : suggested("%1, %2").arg(name, monotone);
}

}  // namespace

QString differenceText(const FusionInputs& before, const Suggestion& suggestion) {
  const FusionInputs& after = suggestion.inputs;
  QStringList parts;
  if (!(after.fcf == before.fcf)) {
    parts.append(curveText(before.fcf, suggestion));
  }
  AdjustmentSettings otherFalloff = before.adjustment;
  otherFalloff.falloff = after.adjustment.falloff;
  if (!(after.adjustment == otherFalloff)) {
    parts.append(suggested("every step of the adjustment"));
  } else if (after.adjustment.falloff != before.adjustment.falloff) {
    parts.append(suggested("falloff %1").arg(QLocale().toString(after.adjustment.falloff)));
  }
  if (suggestion.shift != 0) {
    parts.append(
        suggested("shifted by %1").arg(QString::number(suggestion.shift).replace('-', QChar(0x2212))));
  }
  const QString text = parts.join(QStringLiteral(", "));
  return text.left(1).toUpper() + text.mid(1);
}

QString measureText(const Measures& measures, SuggestionOrder order) {
  const double measure = measureOf(measures, order);
  switch (order) {
    case SuggestionOrder::MeanSeamAngle:
      return suggested("seam %1°").arg(degrees(measure));
    case SuggestionOrder::GreatestSeamAngle:
      return suggested("seam up to %1°").arg(degrees(measure));
    case SuggestionOrder::LeastDistance:
    case SuggestionOrder::GreatestDistance:
      return suggested("up to %1 away").arg(significant(measure, 3));
    case SuggestionOrder::Quality:
      return suggested("triangles %1").arg(QLocale().toString(measure, 'f', 2));
  }
  return {};
}

QStringList orderNames() {
  return {suggested("Mean seam angle"), suggested("Greatest seam angle"), suggested("Distance, least first"),
          suggested("Distance, greatest first"), suggested("Triangle quality")};
}

QString orderSentence(SuggestionOrder order) {
  switch (order) {
    case SuggestionOrder::MeanSeamAngle:
      return suggested("smallest mean angle at the seam first");
    case SuggestionOrder::GreatestSeamAngle:
      return suggested("smallest greatest angle at the seam first");
    case SuggestionOrder::LeastDistance:
      return suggested("nearest to the base first, where they are farthest");
    case SuggestionOrder::GreatestDistance:
      return suggested("farthest from the base first");
    case SuggestionOrder::Quality:
      return suggested("best triangles first, but for the worst twentieth (1: equilateral)");
  }
  return {};
}

}  // namespace graftsman
