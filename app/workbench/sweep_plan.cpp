#include "app/workbench/sweep_plan.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLocale>
#include <QSet>
#include <QStringList>
#include <algorithm>

#include "app/document/commands.h"
#include "core/project/document_edits.h"
#include "core/sweep/sweep_words.h"

namespace graftsman {
namespace {

QString planWords(const char* text) {
  return QCoreApplication::translate("graftsman::SweepPlan", text);
}

// As a file's name has it: what is alike in it is one name.
std::string keyOfName(const QString& name) {
  return sweep_words::lowered(sweep_words::fileWord(name.toStdString()));
}

// Adds a value unless the list has it; its name becomes one of its own.
template <class T>
void offer(std::vector<Offered<T>>& list, QString name, const T& value, bool present) {
  const auto has = [&](const auto& one) { return one.value == value; };
  if (const auto found = std::find_if(list.begin(), list.end(), has); found != list.end()) {
    found->present = found->present || present;
    return;
  }
  // So short that a number behind it is not cut off.
  constexpr qsizetype kLongest = 34;
  while (name.toUtf8().size() > kLongest) {
    name.chop(name.back().isLowSurrogate() ? 2 : 1);
  }
  const auto taken = [&](const QString& tried) {
    return std::any_of(list.begin(), list.end(),
                       [&](const auto& one) { return keyOfName(one.name) == keyOfName(tried); });
  };
  QString unique = name;
  for (int number = 2; taken(unique); ++number) {
    unique = QString("%1 %2").arg(name).arg(number);
  }
  list.push_back({unique, value, present});
}

void offerCurves(SweepOffer& offered, const FCF& present, const VariantList& variants) {
  for (const auto preset :
       {FCF::Preset::Linear, FCF::Preset::Paste, FCF::Preset::KeepBaseSlope, FCF::Preset::Half}) {
    offer(offered.curves, label(preset), FCF::preset(preset), false);
  }
  offer(offered.curves, planWords("Present curve"), present, true);
  for (const auto& variant : variants) {
    if (const Fusion* fusion = find(variant->fusions, variant->shown)) {
      offer(offered.curves, QString::fromStdString(variant->name), fusion->inputs.fcf, false);
    }
  }
}

// Their falloff is the present one: that is a list of its own.
void offerAdjustments(SweepOffer& offered, const AdjustmentSettings& present) {
  const auto steps = [&](const char* name, bool scale, bool lineField, bool exactFit) {
    AdjustmentSettings settings = present;
    settings.rigid = true;
    settings.scale = scale;
    settings.lineField = lineField;
    settings.exactFit = exactFit;
    offer(offered.adjustments, planWords(name), settings, false);
  };
  steps(QT_TRANSLATE_NOOP("graftsman::SweepPlan", "All steps"), true, true, true);
  steps(QT_TRANSLATE_NOOP("graftsman::SweepPlan", "Without line field"), true, false, true);
  steps(QT_TRANSLATE_NOOP("graftsman::SweepPlan", "Rigid only"), false, false, true);
  steps(QT_TRANSLATE_NOOP("graftsman::SweepPlan", "Without exact fit"), true, true, false);
  offer(offered.adjustments, planWords("Present adjustment"), present, true);
}

QString partName(const Fusion& fusion) {
  const QString name = QString::fromStdString(fusion.part->name);
  return fusion.part->result != 0 ? name : QFileInfo(name).completeBaseName();
}

void offerParts(SweepOffer& offered, const Fusion& present, const VariantList& variants) {
  offer(offered.parts, partName(present), present, true);
  for (const auto& variant : variants) {
    const Fusion* other = find(variant->fusions, variant->shown);
    if (other == nullptr || !other->closed || !other->part || !same(other->base, present.base)) {
      continue;
    }
    // Another fusion's result as the part: the document must have that fusion, and not made of this one.
    if (const FusionId source = other->part->result; source != 0) {
      if (find(offered.fusions, source) == nullptr) {
        continue;
      }
      const std::vector<FusionId> needed = upstreamOf(offered.fusions, source);
      if (std::find(needed.begin(), needed.end(), present.id) != needed.end()) {
        continue;
      }
    }
    Fusion fusion = present;
    setAsset(fusion, Side::Part, other->part);
    setAsset(fusion, Side::Base, other->base);
    fusion.inputs.loop = other->inputs.loop;
    offer(offered.parts, planWords("%1 of %2").arg(partName(fusion), QString::fromStdString(variant->name)),
          fusion, false);
  }
}

QString embeddingName(EmbeddingSettings::Method method) {
  switch (method) {
    case EmbeddingSettings::Method::Automatic:
      return planWords("Automatic");
    case EmbeddingSettings::Method::Cotangent:
      return planWords("Cotangent");
    case EmbeddingSettings::Method::MeanValue:
      return planWords("Mean value");
    case EmbeddingSettings::Method::LowStretch:
      return planWords("Low stretch");
  }
  return {};
}

}  // namespace

SweepOffer sweepOffer(const Document& document, FusionId shown) {
  SweepOffer offered;
  offered.fusions = document.fusions;
  offered.shown = shown;
  const Fusion& fusion = *find(document.fusions, shown);
  if (!fusion.part || !fusion.base) {
    offered.problem = planWords("There is nothing to vary yet. Load a part and a base, and make a loop.");
    return offered;
  }
  if (!fusion.closed) {
    offered.problem = planWords("The loop is open: nothing is fused. Close it first.");
    return offered;
  }
  offered.falloff = fusion.inputs.adjustment.falloff;
  offerParts(offered, fusion, document.variants);
  for (const auto method : {EmbeddingSettings::Method::Automatic, EmbeddingSettings::Method::Cotangent,
                            EmbeddingSettings::Method::MeanValue, EmbeddingSettings::Method::LowStretch}) {
    offer(offered.embeddings, embeddingName(method), method, method == fusion.inputs.embedding.method);
  }
  for (int shift = 0; shift < static_cast<int>(fusion.inputs.loop.size()); ++shift) {
    offer(offered.shifts, QString::number(shift), shift, shift == 0);
  }
  offerAdjustments(offered, fusion.inputs.adjustment);
  offerCurves(offered, fusion.inputs.fcf, document.variants);
  return offered;
}

std::size_t SweepPlan::count() const {
  return std::min(std::max<std::size_t>(parts.size(), 1) * values.count(), Sweep::kMostCombinations + 1);
}

const Fusion& SweepPlan::origin(std::size_t number) const {
  return parts.empty() ? *find(fusions, shown) : parts[number / values.count()].value;
}

QString SweepPlan::name(std::size_t number) const {
  const SweepChoice choice = values.choice(number % values.count());
  QStringList words;
  if (!parts.empty()) {
    words.append(parts[number / values.count()].name);
  }
  if (!values.curves.empty()) {
    words.append(QString::fromStdString(values.curves[choice.curve].name));
  }
  if (!values.falloffs.empty()) {
    words.append(
        planWords("falloff %1")
            .arg(QLocale().toString(values.falloffs[choice.falloff], 'g', QLocale::FloatingPointShortest)));
  }
  if (!values.adjustments.empty()) {
    words.append(QString::fromStdString(values.adjustments[choice.adjustment].name));
  }
  if (!values.embeddings.empty()) {
    words.append(embeddingName(values.embeddings[choice.embedding]));
  }
  if (!values.shifts.empty()) {
    words.append(planWords("shift %1").arg(values.shifts[choice.shift]));
  }
  return words.join(", ");
}

FusionList SweepPlan::state(std::size_t number) const {
  Fusion fusion = origin(number);
  Sweep varied = values;
  varied.base = fusion.inputs;
  fusion.inputs = varied.inputs(number % values.count());
  return edits::withFusion(Document{fusions, {}}, std::move(fusion)).fusions;
}

Sweep SweepPlan::checked() const {
  Sweep sweep = values;
  for (const Offered<Fusion>& part : parts) {
    sweep.parts.push_back({part.name.toStdString(), {}, nullptr, {}});
  }
  return sweep;
}

QString countText(const SweepPlan& plan) {
  QStringList factors;
  const auto add = [&](std::size_t length, const char* one, const char* many) {
    if (length > 0) {
      factors.append(QString("%1 %2").arg(length).arg(planWords(length == 1 ? one : many)));
    }
  };
  add(plan.parts.size(), "part", "parts");
  add(plan.values.curves.size(), "curve", "curves");
  add(plan.values.falloffs.size(), "falloff", "falloffs");
  add(plan.values.adjustments.size(), "adjustment", "adjustments");
  add(plan.values.embeddings.size(), "embedding", "embeddings");
  add(plan.values.shifts.size(), "shift", "shifts");
  const std::size_t count = plan.count();
  return QString("%1 = %2").arg(factors.join(QStringLiteral(" × ")),
                                count == 1 ? planWords("1 result") : planWords("%1 results").arg(count));
}

std::vector<QString> uniqueNames(const std::vector<QString>& names, const VariantList& taken) {
  QSet<QString> used;
  for (const auto& variant : taken) {
    used.insert(QString::fromStdString(variant->name));
  }
  std::vector<QString> unique;
  for (const QString& name : names) {
    QString tried = name;
    for (int number = 2; used.contains(tried); ++number) {
      tried = QString("%1 %2").arg(name).arg(number);
    }
    used.insert(tried);
    unique.push_back(tried);
  }
  return unique;
}

}  // namespace graftsman
