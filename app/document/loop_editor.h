#pragma once

#include <QObject>
#include <QSet>
#include <memory>
#include <optional>

#include "app/document/stage_runner.h"
#include "core/base/error.h"
#include "core/mesh/surface_point.h"

namespace graftsman {

class DocumentModel;

/// A pair of which one CV is picked and the other is not yet.
struct HalfPair {
  Side side = Side::Part;  // of the CV that is picked
  SurfacePoint at;
};

/// Turns what a person does with the loop into edits of the document, and keeps what is not part of it: the
/// half-made pair and the selection.
class LoopEditor : public QObject {
  Q_OBJECT

 public:
  explicit LoopEditor(DocumentModel& model, QObject* parent = nullptr);

  [[nodiscard]] const std::optional<HalfPair>& halfPair() const { return half_; }
  [[nodiscard]] const QSet<int>& selection() const { return selection_; }
  void select(const QSet<int>& pairs);

  /// A click on the surface: the first CV of a pair, then its partner on the other mesh; again on the same
  /// mesh, the half-made pair moves there.
  void pick(Side side, const SurfacePoint& at);
  /// A click on a CV: CV 0 closes an open loop, any other is selected.
  void clickCV(int number);
  /// A click on path `number`: a pair there, its partner as far along the same path of the other mesh.
  /// `paths` are those that are seen.
  void insertOnPath(Side side, int number, const SurfacePoint& at, const Outcome* seen);

  /// The last pick() or insertOnPath() was meant otherwise (as half of a double click): as if it had not
  /// been.
  void takeBackPick();

  void startDrag(Side side, int number);
  void dragTo(Side side, int number, const SurfacePoint& to);
  void finishDrag();
  void cancelDrag();
  /// Takes the CVs that moved with the result that they are on (movedCVs()) to be where they are now.
  void keepPlaces(Side side);

  void remove(const QSet<int>& pairs);
  void close();
  void open();
  void reverse();
  void shift();
  void mirror();
  void clear();
  void allowLargeTile();

  /// Esc: abandons the half-made pair, or else the selection. False: there was neither.
  bool backOut();

 Q_SIGNALS:
  void halfPairChanged();
  void selectionChanged(const QSet<int>& pairs);
  /// An edit that core refused.
  void refused(const graftsman::Error& error);

 private:
  struct Drag {
    Side side = Side::Part;
    int number = 0;
    std::optional<Fusion> fusion;  // with the CV at the last legal place
  };

  // What a pick found, to go back to.
  struct BeforePick {
    std::optional<HalfPair> half;
    int historyIndex = 0;
  };

  void setHalfPair(std::optional<HalfPair> half);
  void forgetWhatIsGone();

  DocumentModel& model_;
  std::optional<HalfPair> half_;
  std::shared_ptr<const TriangleMesh> halfMesh_;  // that it was picked on
  std::optional<Drag> drag_;
  std::optional<BeforePick> beforePick_;
  QSet<int> selection_;
};

}  // namespace graftsman
