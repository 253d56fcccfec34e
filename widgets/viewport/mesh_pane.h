#pragma once

#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/fusion/tile.h"
#include "core/mesh/surface_point.h"
#include "widgets/viewport/viewport.h"

namespace graftsman {

/// A CV as a pane shows it: a sphere with its number.
struct CVMark {
  SurfacePoint at;
  int number = 0;
  bool hollow = false;    // its partner is still missing
  bool selected = false;  // a ring round it
  bool problem = false;
};

/// A path of the loop as a pane shows it.
struct PathMark {
  std::vector<Point> points;
  int number = 0;  // leads from CV `number` to the next
  bool problem = false;
};

/// What a pane shows of a loop.
struct LoopMarks {
  std::vector<CVMark> cvs;
  std::vector<PathMark> paths;
  std::shared_ptr<const Tile> tile;  // tinted in the side's colour; null: none
};

/// One mesh in Tiles mode (INTERFACE.md): shows the mesh and its side of the loop, and tells what the person
/// points at, clicks and drags. Knows no document: nothing changes until it is told.
class MeshPane : public Viewport {
  Q_OBJECT

 public:
  explicit MeshPane(Side side, QWidget* parent = nullptr);
  ~MeshPane() override;

  /// Shows `mesh` (null: none) and frames it if it is another one than before. Large meshes are made ready on
  /// a worker thread; until meshShown() the pane shows what it had, busy.
  void setMesh(std::shared_ptr<const TriangleMesh> mesh);
  void setMarks(LoopMarks marks);
  /// Whether clicks may pick (false: the pane only shows).
  void setPicking(bool enabled);
  /// Shows, once, what an undo or redo changed.
  void flashCV(int number);

  /// What a click there would take: a vertex of the nearest face hit; or, with `free`, the very point hit.
  /// nullopt: nothing is hit. Device-independent coordinates.
  [[nodiscard]] std::optional<SurfacePoint> pickAt(const QPointF& position, bool free) const;

 Q_SIGNALS:
  void meshShown();
  /// The vertex under the pointer that a click would take, or −1.
  void vertexHovered(graftsman::Index vertex);
  /// A click on the surface (or Enter, with the keyboard's cursor). Ctrl takes the very point, not the
  /// nearest vertex.
  void surfacePicked(const graftsman::SurfacePoint& at);
  void cvClicked(int number);
  /// A drag of a CV: started once, moved with each new place, then finished or (Esc) cancelled.
  void cvDragStarted(int number);
  void cvDragged(int number, const graftsman::SurfacePoint& to);
  void cvDragFinished(int number);
  void cvDragCancelled(int number);
  /// A click on a path: insert a pair there.
  void pathClicked(int number, const graftsman::SurfacePoint& at);

 private:
  struct Content;
  std::unique_ptr<Content> content_;
};

}  // namespace graftsman

Q_DECLARE_METATYPE(graftsman::SurfacePoint)
