#include "app/workbench/variants_page.h"

#include <QEvent>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <set>
#include <utility>

#include "app/document/document_commands.h"
#include "app/workbench/variant_pictures.h"
#include "core/picture/fusion_view.h"
#include "widgets/theme/theme.h"
#include "widgets/variants/variant_delegate.h"
#include "widgets/variants/variants_gallery.h"
#include "widgets/variants/variants_model.h"

namespace graftsman {
namespace {

// Whether both lists hold equal fusions; the very same ones are not looked into.
bool equal(const FusionList& a, const FusionList& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x == y || *x == *y; });
}

std::set<VariantId> setOf(const std::vector<VariantId>& ids) {
  return {ids.begin(), ids.end()};
}

}  // namespace

VariantsPage::VariantsPage(DocumentModel& model, std::function<View()> view, QWidget* parent)
    : QWidget(parent),
      model_(model),
      view_(std::move(view)),
      gallery_(new VariantsGallery(this)),
      pictures_(new VariantPictures(this)) {
  setObjectName("variantsPage");
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(gallery_);
  gallery_->setEmptyText(
      tr("No variants yet. “Keep as a variant” (Ctrl+B) keeps the loop, the curve and all settings as they "
         "are now; go on from there, and keep what you like. A state of the history becomes a variant by "
         "its context menu."));
  connectGallery();
  connect(&model, &DocumentModel::documentChanged, this, &VariantsPage::showVariants);
  connect(pictures_, &VariantPictures::drawn, this, [this] {
    showPictures();
    if (pictures_->missing() == 0) {
      requestPictures();  // those that came out of a file may be out of date
    }
  });
  connect(pictures_, &VariantPictures::missingChanged, this, [this](int missing) {
    gallery_->setActivity(missing == 0   ? QString()
                          : missing == 1 ? tr("one picture to come")
                                         : tr("%1 pictures to come").arg(missing));
  });
  pictures_->setDark(themeFor(palette()).dark);
  showVariants();
}

void VariantsPage::connectGallery() {
  connect(gallery_, &VariantsGallery::selectionChanged, this, &VariantsPage::selectionChanged);
  connect(gallery_->model(), &VariantsModel::renameWanted, this, [this](int id, const QString& name) {
    // The gallery is still at work on the row.
    QTimer::singleShot(0, this, [this, id, name] {
      if (graftsman::find(model_.document().variants, id) != nullptr) {
        push(std::make_unique<RenameVariant>(model_, id, name));
      }
    });
  });
  connect(gallery_, &VariantsGallery::noteWanted, this,
          [this](int id, const QString& note) { push(std::make_unique<NoteVariant>(model_, id, note)); });
  connect(gallery_, &VariantsGallery::starWanted, this, &VariantsPage::star);
  connect(gallery_, &VariantsGallery::removeWanted, this, &VariantsPage::remove);
  connect(gallery_, &VariantsGallery::applyWanted, this, [this](int id) { apply(id); });
}

std::vector<VariantId> VariantsPage::selected() const {
  return gallery_->selected();
}

void VariantsPage::push(std::unique_ptr<EditCommand> command) {
  model_.push(std::move(command));
}

// A command that adds a variant at the end.
void VariantsPage::add(std::unique_ptr<EditCommand> command) {
  push(std::move(command));
  const Variant& added = *model_.document().variants.back();
  gallery_->select({added.id});
  Q_EMIT told(tr("Kept as “%1”. F4 shows the variants.").arg(QString::fromStdString(added.name)));
}

void VariantsPage::keep() {
  add(std::make_unique<AddVariant>(model_));
}

void VariantsPage::keepState(int historyIndex) {
  const QUndoStack& history = *model_.history();
  const auto* command =
      dynamic_cast<const EditCommand*>(history.command(historyIndex > 0 ? historyIndex - 1 : 0));
  if (command == nullptr) {
    keep();  // there is no history: the present state is the only one
  } else if (historyIndex > 0) {
    add(std::make_unique<AddVariant>(model_, command->after().fusions, command->showsAfter()));
  } else {
    add(std::make_unique<AddVariant>(model_, command->before().fusions, command->showsBefore()));
  }
}

void VariantsPage::apply() {
  if (const std::vector<VariantId> ids = selected(); ids.size() == 1) {
    apply(ids.front());
  }
}

void VariantsPage::apply(VariantId id) {
  const QString name = QString::fromStdString(graftsman::find(model_.document().variants, id)->name);
  push(std::make_unique<ApplyVariant>(model_, id));
  Q_EMIT told(tr("“%1” is the present state: F3 shows it.").arg(name));
}

void VariantsPage::star(const std::vector<int>& ids, bool starred) {
  push(std::make_unique<StarVariants>(model_, setOf(ids), starred));
}

void VariantsPage::toggleStar() {
  const std::vector<VariantId> ids = selected();
  if (!ids.empty()) {
    star(ids, !std::all_of(ids.begin(), ids.end(), [this](VariantId id) {
           return graftsman::find(model_.document().variants, id)->starred;
         }));
  }
}

void VariantsPage::remove() {
  if (const std::vector<VariantId> ids = selected(); !ids.empty()) {
    push(std::make_unique<RemoveVariants>(model_, setOf(ids)));
  }
}

void VariantsPage::giveCurve() {
  if (const std::vector<VariantId> ids = selected(); !ids.empty()) {
    push(std::make_unique<ChangeVariants>(
        model_, setOf(ids),
        [curve = model_.committed().inputs.fcf](Fusion& fusion) { fusion.inputs.fcf = curve; }, tr("Curve")));
  }
}

void VariantsPage::giveAdjustment() {
  if (const std::vector<VariantId> ids = selected(); !ids.empty()) {
    push(std::make_unique<ChangeVariants>(
        model_, setOf(ids),
        [settings = model_.committed().inputs.adjustment](Fusion& fusion) {
          fusion.inputs.adjustment = settings;
        },
        tr("Adjustment")));
  }
}

void VariantsPage::cross() {
  if (const std::vector<VariantId> ids = selected(); ids.size() == 2) {
    add(std::make_unique<CrossVariants>(model_, ids.front(), ids.back()));
  }
}

void VariantsPage::takeView() {
  const View view = view_();
  if (!view.results) {
    Q_EMIT told(tr("There is no result to look at. Close the loop first."));
    return;
  }
  setCamera(view);
  requestPictures();
}

// So that all that the curve makes of the shape is in the pictures, as far as the pane shows it.
void VariantsPage::setCamera(const View& view) {
  const double aspect =
      static_cast<double>(VariantDelegate::kPicture.width()) / VariantDelegate::kPicture.height();
  pictures_->setCamera(pictureCamera(view.pane, shownPoints(*view.results, FusionView::Whole), aspect));
}

void VariantsPage::showVariants() {
  const Document& document = model_.document();
  std::vector<VariantRow> rows;
  for (const auto& variant : document.variants) {
    rows.push_back({variant->id, QString::fromStdString(variant->name), QString::fromStdString(variant->note),
                    variant->starred, equal(variant->fusions, document.fusions)});
  }
  gallery_->model()->setRows(std::move(rows));
  showPictures();
  requestPictures();
  Q_EMIT selectionChanged();
}

void VariantsPage::showPictures() {
  for (const auto& variant : model_.document().variants) {
    const VariantPictures::Shown shown = pictures_->shown(*variant);
    if (!shown.picture.isNull() || !shown.problem.isEmpty()) {
      gallery_->model()->setPicture(variant->id, shown.picture, shown.problem);
    }
  }
}

void VariantsPage::requestPictures() {
  if (!std::exchange(requested_, true)) {
    QTimer::singleShot(0, this, &VariantsPage::requestNow);
  }
}

void VariantsPage::requestNow() {
  requested_ = false;
  const VariantList& variants = model_.document().variants;
  if (variants.empty()) {
    pictures_->cancel();
    return;
  }
  const View view = view_();
  if (!pictures_->camera() && view.results) {
    setCamera(view);
  }
  pictures_->request(variants, view.results);
}

void VariantsPage::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) {
    pictures_->setDark(themeFor(palette()).dark);
    requestPictures();
  }
  QWidget::changeEvent(event);
}

}  // namespace graftsman
