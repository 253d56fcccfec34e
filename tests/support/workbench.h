#pragma once

#include <Eigen/Geometry>
#include <QAction>
#include <QApplication>
#include <QDropEvent>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPointer>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <memory>

#include "app/document/stage_runner.h"
#include "app/workbench/actions.h"
#include "app/workbench/fusion_page.h"
#include "app/workbench/job_queue.h"
#include "app/workbench/main_window.h"
#include "core/io/scenario.h"
#include "tests/support/samples.h"
#include "widgets/panels/elided_label.h"
#include "widgets/viewport/mesh_pane.h"
#include "widgets/viewport/result_pane.h"

/// The real window under a test's hands.
namespace graftsman {

inline constexpr int kPatienceMs = 60'000;

/// True once the keyboard is the window's own, as its shortcuts need it. (To Qt Test's qWaitForWindowActive()
/// a window is active, too, while its parent is.) On a bare display no window manager gives it the keyboard.
[[nodiscard]] inline bool activated(QWidget& window) {
  window.activateWindow();
  return QTest::qWaitFor([&window] { return QApplication::activeWindow() == &window; }, kPatienceMs);
}

struct Workbench {
  QTemporaryDir folder;
  std::unique_ptr<MainWindow> window;

  explicit Workbench(const QString& recovery = {}) {
    window = std::make_unique<MainWindow>(recovery.isEmpty() ? folder.filePath("recovery") : recovery);
    window->resize(1280, 800);
    window->show();
    activate();
  }

  [[nodiscard]] MeshPane* pane(Side side) const {
    return window->findChild<MeshPane*>(side == Side::Part ? "partPane" : "basePane");
  }
  [[nodiscard]] ResultPane* resultPane() const { return window->findChild<ResultPane*>("resultPane"); }
  [[nodiscard]] QAction* action(const char* name) const { return window->actions()[name]; }
  [[nodiscard]] const Fusion& fusion() const { return window->model().fusion(); }

  /// True once no stage and no job is under way.
  [[nodiscard]] bool settle() const {
    return QTest::qWaitFor([this] { return !window->jobs().busy() && !window->runner().busy(); },
                           kPatienceMs);
  }
  [[nodiscard]] bool openSample(const std::string& name) const {
    window->openFile(QString::fromStdString(samples::scenarioPath(name).string()));
    return settle() && window->fusionPage().shown();
  }

  /// Turns the pane's camera so that the point is seen from outside, in the middle.
  void lookAt(MeshPane* pane, const TriangleMesh& mesh, Index vertex) const {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Index h = mesh.outgoing(vertex);
    const Index first = h;
    do {
      const Face& face = mesh.face(TriangleMesh::faceOf(h));
      normal += (mesh.point(face[1]) - mesh.point(face[0]))
                    .cross(mesh.point(face[2]) - mesh.point(face[0]))
                    .stableNormalized();
      h = mesh.twin(TriangleMesh::prev(h));
    } while (h >= 0 && h != first);
    normal.normalize();
    const Eigen::Vector3d up =
        std::abs(normal.z()) < 0.9 ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
    pane->setCamera({mesh.point(vertex) + 0.25 * mesh.diagonal() * normal, mesh.point(vertex), up});
  }

  [[nodiscard]] const TriangleMesh& mesh(Side side) const {
    return side == Side::Part ? *fusion().inputs.part : *fusion().inputs.base;
  }

  /// Where a vertex is seen after the pane's camera was turned to it and the mesh was made ready.
  [[nodiscard]] QPoint placeOf(Side side, Index vertex) const {
    QPoint at;
    const auto inView = [&] {
      lookAt(pane(side), mesh(side), vertex);
      at = pane(side)->screenPosition(mesh(side).point(vertex)).toPoint();
      return pane(side)->pickAt(at, false).has_value();
    };
    if (!QTest::qWaitFor(inView, kPatienceMs)) {
      qFatal("nothing to pick");
    }
    return at;
  }

  /// Clicks on a vertex of the pane's mesh.
  void clickVertex(Side side, Index vertex) const {
    const QPoint at = placeOf(side, vertex);
    QTest::mouseMove(pane(side), at);
    QTest::mouseClick(pane(side), Qt::LeftButton, {}, at);
  }

  void drop(QWidget* target, const QString& path) const {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    const QPoint at = target->rect().center();
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(target, &enter);
    QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(target, &dropped);
  }

  /// Waits for a dialog of this name, types the path as a person would, and accepts.
  void answerFileDialog(const char* name, const QString& path) const {
    auto* dialog = window->findChild<QFileDialog*>(name);
    if (!dialog || !QTest::qWaitForWindowExposed(dialog)) {
      qFatal("no dialog %s", name);
    }
    auto* typed = dialog->findChild<QLineEdit*>("fileNameEdit");
    // It lists the folder on a thread of its own and may put another file's name in place of what was typed.
    typed->setCompleter(nullptr);
    typed->setFocus();
    const QPointer<QFileDialog> open(dialog);
    const auto closed = [&] {
      if (open && open->isVisible()) {
        // Anew each time: whether the name can be taken is decided when it changes, by what of the folder has
        // been listed until then.
        typed->clear();
        QTest::keyClicks(typed, path);
        QTest::keyClick(typed, Qt::Key_Return);
      }
      return !open || !open->isVisible();
    };
    if (!QTest::qWaitFor(closed, kPatienceMs)) {
      qFatal("%s does not take %s", name, qPrintable(path));
    }
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    activate();
  }

  /// Takes the keyboard back from a dialog: on a bare display no window manager does.
  void activate() const {
    window->activateWindow();
    if (!QTest::qWaitFor([this] { return window->isActiveWindow() || !window->isVisible(); }, kPatienceMs)) {
      qFatal("the window does not become active");
    }
  }

  /// What the status bar says.
  [[nodiscard]] QString status() const { return window->findChild<ElidedLabel*>("statusMessage")->text(); }
};

}  // namespace graftsman
