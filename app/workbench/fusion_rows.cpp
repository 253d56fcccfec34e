#include "app/workbench/fusion_rows.h"

#include <QCoreApplication>
#include <QLocale>
#include <set>

namespace graftsman {
namespace {

QString say(const char* text) {
  return QCoreApplication::translate("graftsman::FusionRows", text);
}

QString facesText(std::size_t count) {
  return say("%1 faces").arg(QLocale().toString(static_cast<qulonglong>(count)));
}

// As label() names what it is made of.
QString sourceName(const FusionList& fusions, const MeshAsset& asset) {
  return asset.result != 0 ? fusionName(fusions, asset.result)
                           : QString::fromStdString(std::filesystem::path(asset.name).stem().string());
}

class Tree {
 public:
  Tree(const FusionList& fusions, FusionId shown, const KnownResults& known)
      : fusions_(fusions), shown_(shown), known_(known) {}

  [[nodiscard]] FusionRow fusionRow(const Fusion& fusion) const {
    FusionRow row;
    row.fusion = fusion.id;
    row.name = fusionName(fusions_, fusion.id);
    row.shown = fusion.id == shown_;
    describe(fusion, row);
    row.rows = {sideRow(fusion, Side::Part), sideRow(fusion, Side::Base)};
    return row;
  }

 private:
  [[nodiscard]] FusionRow sideRow(const Fusion& fusion, Side side) const {
    FusionRow row;
    const std::shared_ptr<const MeshAsset>& asset = fusion.of(side);
    const Fusion* source = find(fusions_, fusion.upstream(side));
    if (source != nullptr) {
      row = fusionRow(*source);
    } else if (!asset) {
      row.name = side == Side::Part ? say("no part yet") : say("no base yet");
    } else {
      row.name = QString::fromStdString(asset->name);
      row.what = asset->mesh ? facesText(static_cast<std::size_t>(asset->mesh->faceCount())) : QString();
    }
    row.owner = fusion.id;
    row.side = side;
    return row;
  }

  // What is the matter with it, or how large its result is.
  void describe(const Fusion& fusion, FusionRow& row) const {
    const auto known = known_.find(fusion.id);
    if (!fusion.part || !fusion.base) {
      row.what = fusion.base ? say("no part") : fusion.part ? say("no base") : say("empty");
    } else if (!fusion.closed) {
      row.what = say("open loop");
    } else if (known != known_.end() && !known->second.problem.isEmpty()) {
      row.what = say("no result");
      row.problem = known->second.problem;
    } else if (known != known_.end()) {
      row.what = facesText(known->second.faces);
    }
  }

  const FusionList& fusions_;
  FusionId shown_;
  const KnownResults& known_;
};

}  // namespace

QString fusionName(const FusionList& fusions, FusionId id) {
  const Fusion* fusion = find(fusions, id);
  if (fusion == nullptr) {
    return {};
  }
  if (!fusion->name.empty() || !fusion->part || !fusion->base) {
    return QString::fromStdString(label(*fusion));
  }
  return say("%1 on %2").arg(sourceName(fusions, *fusion->part), sourceName(fusions, *fusion->base));
}

std::shared_ptr<const MeshAsset> firstBase(const FusionList& fusions, FusionId id) {
  const Fusion* fusion = find(fusions, id);
  while (fusion != nullptr && fusion->upstream(Side::Base) != 0) {
    fusion = find(fusions, fusion->upstream(Side::Base));
  }
  return fusion != nullptr ? fusion->base : nullptr;
}

std::vector<FusionRow> fusionRows(const FusionList& fusions, FusionId shown, const KnownResults& known) {
  std::set<FusionId> used;
  for (const auto& fusion : fusions) {
    used.insert({fusion->upstream(Side::Part), fusion->upstream(Side::Base)});
  }
  std::vector<FusionRow> rows;
  const Tree tree(fusions, shown, known);
  for (const auto& fusion : fusions) {
    if (!used.contains(fusion->id)) {
      rows.push_back(tree.fusionRow(*fusion));
    }
  }
  return rows;
}

}  // namespace graftsman
