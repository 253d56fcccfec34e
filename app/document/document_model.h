#pragma once

#include <QObject>
#include <QUndoStack>
#include <optional>

#include "core/project/evaluate.h"
#include "core/project/history.h"

namespace graftsman {

class EditCommand;

/// What an edit touched, so that undo and redo can show it.
struct Touched {
  std::optional<int> cv;
  std::optional<Side> side;  // of the CV, where the other one stayed
  std::optional<int> curvePoint;
  bool adjustment = false;
};

/// Why what is shown changed.
enum class Change {
  Reset,     // another document altogether
  Edit,      // an edit was made
  History,   // undone or redone
  Drag,      // a drag under way shows what it would give
  Shown,     // another fusion of the document is shown
  Upstream,  // a result that the shown fusion is made of was computed anew
};

/// The document that is open, the fusion of it that is shown, and the undo history. All changes go through
/// push(), except while a drag is under way: drag() shows what it would give without a step of history, and
/// the push at its end is the one step; cancelDrag() leaves no trace.
class DocumentModel : public QObject {
  Q_OBJECT

 public:
  explicit DocumentModel(QObject* parent = nullptr) : QObject(parent) {}

  /// Without a drag under way: what is saved.
  [[nodiscard]] const Document& document() const { return document_; }
  /// The document with the fusion of the drag under way, if there is one: what is to be computed.
  [[nodiscard]] Document shownDocument() const;

  /// The fusion that is shown and edited, resolved as far as its upstream is known: that of the drag under
  /// way, if there is one.
  [[nodiscard]] const Fusion& fusion() const { return dragged_ ? *dragged_ : fusion_; }
  /// Without a drag under way: what an edit starts from.
  [[nodiscard]] const Fusion& committed() const { return fusion_; }
  [[nodiscard]] FusionId shown() const { return fusion_.id; }
  [[nodiscard]] bool dragging() const { return dragged_.has_value(); }
  [[nodiscard]] QUndoStack* history() { return &history_; }
  /// The undo history as a value, as projects keep it.
  [[nodiscard]] History historyValue() const;
  /// Forgets every step; the document stays. Whether it is clean is for the caller to say.
  void forgetHistory();

  /// Makes the edit; takes it. An edit that changes nothing leaves no step.
  void push(std::unique_ptr<EditCommand> command);
  void drag(Fusion fusion);
  void cancelDrag();
  /// Shows another fusion of the document; no step of history. Without one of that id: nothing.
  void show(FusionId id);
  /// Shows another document, clean, with a history of which it is the present state. `shown`: one of its
  /// fusions.
  void reset(const Document& document, FusionId shown, const History& past = {});
  /// A document of one fusion.
  void reset(const Fusion& fusion);
  /// The meshes of results as they were computed last, and the fusion that they were computed for, resolved.
  /// The shown fusion takes those that it is made of.
  void setResultAssets(const ResultAssets& assets, const Fusion& computed);

 Q_SIGNALS:
  /// After each change of fusion().
  void changed(graftsman::Change change, const graftsman::Touched& touched);
  /// After each change of document().
  void documentChanged();

 private:
  friend class EditCommand;
  void apply(const Document& document, FusionId shown, Change change, const Touched& touched);
  void take(const Document& document, FusionId shown);
  void refill(const History& past);

  Document document_;
  Fusion fusion_;  // of document_, resolved
  std::optional<Fusion> dragged_;
  ResultAssets assets_;
  QUndoStack history_;
  bool refilling_ = false;  // the history is filled with what was done before: nothing changes
};

}  // namespace graftsman
