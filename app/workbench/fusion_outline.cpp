#include "app/workbench/fusion_outline.h"

#include <QMenu>
#include <algorithm>
#include <utility>

#include "app/document/document_commands.h"
#include "app/document/stage_runner.h"
#include "core/project/document_edits.h"
#include "widgets/panels/fusion_tree_panel.h"
#include "widgets/theme/icon.h"

namespace graftsman {
namespace {

bool isIn(const std::vector<FusionId>& ids, FusionId id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

// Whether what the fusion's result is made of differs between the two.
bool differs(const FusionList& before, const FusionList& now, FusionId id) {
  const std::vector<FusionId> needed = upstreamOf(now, id);
  return std::any_of(needed.begin(), needed.end(), [&](FusionId one) {
    const Fusion* old = find(before, one);
    const Fusion* present = find(now, one);
    return old == nullptr || (old != present && !(*old == *present));
  });
}

QString sideText(const QString& part, const QString& base, Side side) {
  return side == Side::Part ? part : base;
}

// Names are shown as they are: "&" is no mark of a key.
QString inMenu(QString name) {
  return name.replace('&', "&&");
}

}  // namespace

FusionOutline::FusionOutline(DocumentModel& model, QObject* parent)
    : QObject(parent), model_(model), panel_(new FusionTreePanel) {
  connect(&model, &DocumentModel::documentChanged, this, [this] {
    forgetWhatIsStale();
    showRows();
  });
  connect(&model, &DocumentModel::changed, this, [this](Change change) {
    if (change == Change::Reset) {
      known_.clear();
    }
    if (change == Change::Shown || change == Change::Reset) {
      showRows();
    }
  });
  connect(panel_, &FusionTreePanel::showWanted, &model, &DocumentModel::show);
  connect(panel_, &FusionTreePanel::removeWanted, this, &FusionOutline::remove);
  connect(panel_, &FusionTreePanel::renameWanted, this, [this](FusionId id, const QString& name) {
    model_.push(std::make_unique<RenameFusion>(model_, id, name));
  });
  connect(panel_, &FusionTreePanel::contextMenuWanted, this, &FusionOutline::showContextMenu);
  showRows();
}

void FusionOutline::setOutcome(const Outcome& outcome) {
  const Error* error = outcome.results && outcome.results->error ? &*outcome.results->error : nullptr;
  const auto learn = [&](FusionId id, bool has, std::size_t faces) {
    if (has) {
      known_[id] = {faces, {}};
    } else if (error && error->code != ErrorCode::Cancelled) {
      known_[id] = {0, QString::fromStdString(error->message)};
    } else {
      known_.erase(id);
    }
  };
  for (const auto& [id, asset] : outcome.assets) {
    learn(id, asset != nullptr, asset ? static_cast<std::size_t>(asset->mesh->faceCount()) : 0);
  }
  const bool fused = outcome.results && outcome.results->fused && !error;
  learn(outcome.fusion.id, fused, fused ? outcome.results->fused->faces().size() : 0);
  showRows();
}

void FusionOutline::showRows() {
  panel_->setRows(fusionRows(model_.document().fusions, model_.shown(), known_));
}

// What is known of the shown fusion is about to be known anew; of the others it is until they change.
void FusionOutline::forgetWhatIsStale() {
  const FusionList& now = model_.document().fusions;
  const std::vector<FusionId> computed = upstreamOf(now, model_.shown());
  std::erase_if(known_, [&](const auto& one) {
    return find(now, one.first) == nullptr ||
           (!isIn(computed, one.first) && differs(before_, now, one.first));
  });
  before_ = now;
}

void FusionOutline::addEmpty() {
  model_.push(std::make_unique<AddFusion>(model_, nullptr, nullptr));
  Q_EMIT tilesWanted();
}

void FusionOutline::fuseOnto(FusionId id) {
  if (const Fusion* fusion = find(model_.document().fusions, id)) {
    model_.push(std::make_unique<AddFusion>(model_, nullptr, edits::resultAsset(*fusion)));
    Q_EMIT tilesWanted();
  }
}

void FusionOutline::take(FusionId source, Side side) {
  Result<Document> after = edits::takeResult(model_.document(), model_.shown(), side, source);
  if (!after) {
    Q_EMIT refused(after.error());
    return;
  }
  model_.push(std::make_unique<TakeResult>(model_, std::move(*after), model_.shown(), side, source));
  Q_EMIT tilesWanted();
}

void FusionOutline::remove(FusionId id) {
  if (find(model_.document().fusions, id) != nullptr) {
    model_.push(std::make_unique<RemoveFusion>(model_, id));
  }
}

void FusionOutline::editName(FusionId id) {
  panel_->editName(id);
}

void FusionOutline::fillTakeMenu(QMenu& menu, Side side) {
  menu.clear();
  for (const auto& fusion : model_.document().fusions) {
    if (fusion->id != model_.shown()) {
      QAction* action = menu.addAction(inMenu(fusionName(model_.document().fusions, fusion->id)));
      connect(action, &QAction::triggered, this, [this, id = fusion->id, side] { take(id, side); });
    }
  }
  if (menu.isEmpty()) {
    menu.addAction(tr("There is no other fusion"))->setEnabled(false);
  }
}

void FusionOutline::showContextMenu(FusionId id, const QPoint& at) {
  auto* menu = new QMenu(panel_);
  menu->setObjectName("fusionsMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  const auto add = [&](const QString& text, const char* iconName, std::function<void()> what) {
    connect(menu->addAction(icon(iconName), text), &QAction::triggered, this,
            [what = std::move(what)] { what(); });
  };
  if (id != 0) {
    const bool shown = id == model_.shown();
    const QString name = inMenu(fusionName(model_.document().fusions, model_.shown()));
    if (!shown) {
      add(tr("Show"), "", [this, id] { model_.show(id); });
    }
    add(tr("Fuse onto this result"), "result", [this, id] { fuseOnto(id); });
    for (const Side side : {Side::Part, Side::Base}) {
      if (!shown) {
        add(sideText(tr("Take as the part of “%1”"), tr("Take as the base of “%1”"), side).arg(name),
            side == Side::Part ? "load-part" : "load-base", [this, id, side] { take(id, side); });
      }
    }
    menu->addSeparator();
    add(tr("Rename"), "", [this, id] { editName(id); });
    add(tr("Remove"), "delete", [this, id] { remove(id); });
    menu->addSeparator();
  }
  add(tr("New fusion"), "new", [this] { addEmpty(); });
  menu->popup(at);
}

}  // namespace graftsman
