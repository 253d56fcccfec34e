#pragma once

#include <memory>
#include <vector>

#include "core/base/error.h"
#include "core/fusion/tile.h"
#include "core/mesh/surface_point.h"
#include "widgets/viewport/viewport.h"

namespace graftsman {

class ShownMesh;

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
  friend bool operator==(const PathMark&, const PathMark&) = default;
};

/// What a pane shows of a loop.
struct LoopMarks {
  std::vector<CVMark> cvs;
  std::vector<PathMark> paths;
  std::shared_ptr<const Tile> tile;  // tinted in the side's colour; null: none
};

/// One mesh in Tiles mode (INTERFACE.md): shows the mesh and its side of the loop, and tells what the person
/// points at, clicks and drags. Knows no document: nothing changes until it is told.
///
/// With the keyboard, the arrows walk from vertex to vertex in the direction seen, among those in sight, and
/// Enter picks; before the first arrow (and again once the mouse has moved) Enter is left to the window.
class MeshPane : public Viewport {
  Q_OBJECT

 public:
  explicit MeshPane(Side side, QWidget* parent = nullptr);
  ~MeshPane() override;

  /// Shows `mesh` (null: none); a camera that was aimed frames it. The marks of the one before go. It is made
  /// ready on a worker thread: until meshShown() the pane shows what it had, dimmed and without marks, and
  /// nothing can be picked.
  void setMesh(std::shared_ptr<const TriangleMesh> mesh);
  /// What is marked on the mesh last set. Marks of vertices and faces that it lacks are left out.
  void setMarks(LoopMarks marks);
  /// Whether clicks may pick (false: the pane only shows).
  void setPicking(bool enabled);
  /// Shows, once, what an undo or redo changed; the view glides to it where it is out of sight.
  void flashCV(int number);

  /// What a click there would take: a vertex of the nearest face hit; or, with `free`, the very point hit.
  /// nullopt: nothing is hit.
  [[nodiscard]] std::optional<SurfacePoint> pickAt(const QPointF& position, bool free) const;

 Q_SIGNALS:
  /// The mesh last set is shown, and can be picked from. Never from within setMesh().
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
  /// The click just told by surfacePicked() or pathClicked() was the first half of a double-click, which sets
  /// the pivot: what it did is to be taken back.
  void pickTakenBack();

 protected:
  [[nodiscard]] std::optional<Point> surfaceAt(const QPointF& position) const override;
  [[nodiscard]] std::vector<StandIn*> standIns() const override;
  void prepareFrame(const CameraView& view) override;
  void paintOver(QPainter& painter, const CameraView& view) override;
  void applyTheme(const Theme& theme) override;

  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void leaveEvent(QEvent* event) override;
  bool event(QEvent* event) override;

 private:
  struct Content;
  struct Pointed;
  void showMesh(std::shared_ptr<const ShownMesh> shown);
  void showMarks();
  void showTile();
  void bringIntoSight(const SurfacePoint& at);
  void paintProblemPaths(QPainter& painter, const CameraView& view);
  void paintCVs(QPainter& painter, const CameraView& view);
  void paintPointed(QPainter& painter, const CameraView& view);
  [[nodiscard]] Pointed pointedAt(const QPointF& position, bool free) const;
  void hover(const Pointed& pointed);
  void click(const Pointed& pointed);
  void dragTo(const QPointF& position, bool free);
  void cancelDrag();
  void walk(Qt::Key arrow);
  void pickByKeyboard();

  std::unique_ptr<Content> content_;
};

}  // namespace graftsman

Q_DECLARE_METATYPE(graftsman::SurfacePoint)
