#include "app/document/document_model.h"

#include <utility>

#include "app/document/commands.h"

namespace graftsman {

void DocumentModel::push(std::unique_ptr<EditCommand> command) {
  if (command->changesNothing()) {
    cancelDrag();
    return;
  }
  history_.push(command.release());
}

void DocumentModel::drag(Document document) {
  dragged_ = std::move(document);
  Q_EMIT changed(Change::Drag, {});
}

void DocumentModel::cancelDrag() {
  if (dragged_) {
    dragged_.reset();
    Q_EMIT changed(Change::Drag, {});
  }
}

void DocumentModel::reset(Document document) {
  dragged_.reset();
  history_.clear();
  document_ = std::move(document);
  Q_EMIT changed(Change::Reset, {});
}

void DocumentModel::apply(const Document& document, Change change, const Touched& touched) {
  dragged_.reset();
  document_ = document;
  Q_EMIT changed(change, touched);
}

}  // namespace graftsman
