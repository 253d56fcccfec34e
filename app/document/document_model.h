#pragma once

#include <QObject>
#include <QUndoStack>
#include <optional>

#include "core/project/document.h"

namespace graftsman {

class EditCommand;

/// What an edit touched, so that undo and redo can show it.
struct Touched {
  std::optional<int> cv;
  std::optional<Side> side;  // of the CV, where the other one stayed
  std::optional<int> curvePoint;
  bool adjustment = false;
};

/// Why the shown document changed.
enum class Change {
  Reset,    // another document altogether
  Edit,     // an edit was made
  History,  // undone or redone
  Drag,     // a drag under way shows what it would give
};

/// The document that is open, and its undo history. All changes go through push(), except while a drag is
/// under way: drag() shows what it would give without a step of history, and the push at its end is the one
/// step; cancelDrag() leaves no trace.
class DocumentModel : public QObject {
  Q_OBJECT

 public:
  explicit DocumentModel(QObject* parent = nullptr) : QObject(parent) {}

  /// As shown: that of the drag under way, if there is one.
  [[nodiscard]] const Document& document() const { return dragged_ ? *dragged_ : document_; }
  /// Without a drag under way: what is saved, and what an edit starts from.
  [[nodiscard]] const Document& committed() const { return document_; }
  [[nodiscard]] bool dragging() const { return dragged_.has_value(); }
  [[nodiscard]] QUndoStack* history() { return &history_; }

  /// Makes the edit; takes it. An edit that changes nothing leaves no step.
  void push(std::unique_ptr<EditCommand> command);
  void drag(Document document);
  void cancelDrag();
  /// Shows another document, with an empty history.
  void reset(Document document);

 Q_SIGNALS:
  /// After each change of document().
  void changed(graftsman::Change change, const graftsman::Touched& touched);

 private:
  friend class EditCommand;
  void apply(const Document& document, Change change, const Touched& touched);

  Document document_;
  std::optional<Document> dragged_;
  QUndoStack history_;
};

}  // namespace graftsman
