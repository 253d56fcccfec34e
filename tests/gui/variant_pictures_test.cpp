#include <QSignalSpy>
#include <QtTest>

#include "app/workbench/variant_pictures.h"
#include "core/picture/fusion_view.h"
#include "core/project/document_edits.h"
#include "tests/support/documents.h"
#include "tests/support/shapes.h"
#include "widgets/viewport/camera_view.h"

using namespace graftsman;

namespace {

constexpr int kPatienceMs = 60'000;
constexpr double kAspect = 4.0 / 3;

/// Variants of a sample, a curve of its own each.
VariantList variants(int count) {
  Fusion fusion = samples::fusion("fig4c_cone_sphere");
  Document document = samples::documentOf(fusion);
  for (int i = 0; i < count; ++i) {
    const double f = static_cast<double>(i) / count;
    fusion.inputs.fcf = *FCF::through({{0, 0}, {0.3, f}, {0.6, f}, {1, 1}}, true);
    document = edits::addVariant(edits::withFusion(std::move(document), fusion), fusion.id);
  }
  return document.variants;
}

PictureCamera cameraOf(const VariantList& list) {
  const TriangleMesh& base = *list.front()->fusions.front()->inputs.base;
  return frame(base.points(), {}, kAspect);
}

bool settle(const VariantPictures& pictures) {
  return QTest::qWaitFor([&] { return pictures.missing() == 0; }, kPatienceMs);
}

/// Where a point is in a picture: −1 to 1 from edge to edge in both directions.
Eigen::Vector2d place(const PictureCamera& camera, const Point& point) {
  const ViewFrame axes = viewFrame(camera);
  const Eigen::Vector3d d = point - camera.position;
  const double half = std::tan(camera.viewAngle / 2) * d.dot(axes.into);
  return {d.dot(axes.right) / (half * kAspect), d.dot(axes.up) / half};
}

}  // namespace

class VariantPicturesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aPictureShowsWhatThePaneShowsTightly_data() {
    QTest::addColumn<QSizeF>("size");
    QTest::newRow("tall") << QSizeF(300, 700);
    QTest::newRow("square") << QSizeF(500, 500);
    QTest::newRow("wide") << QSizeF(900, 300);
  }
  void aPictureShowsWhatThePaneShowsTightly() {
    QFETCH(QSizeF, size);
    std::vector<Point> points = shapes::icosphere(3)->points();
    Eigen::AlignedBox3d box;
    for (Point& point : points) {
      point = {point.x() + 5, 0.3 * point.y(), 2 * point.z()};
      box.extend(point);
    }
    CameraView view{{{5, -9, 1}, {5, 0, 0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()}, size};
    view.camera = view.framing(box);
    const PictureCamera camera = pictureCamera(view, points, kAspect);
    double farthest = 0;
    for (const Point& point : points) {
      farthest = std::max(farthest, place(camera, point).cwiseAbs().maxCoeff());
    }
    QVERIFY2(farthest < 0.95 && farthest > 0.8, qPrintable(QString::number(farthest)));
  }

  void ofAShapeThatIsLargerThanThePaneAPictureShowsThePane() {
    const std::vector<Point> points = shapes::icosphere(4)->points();
    const CameraView view{{{0, -1.5, 0}, {0, 0, 0}, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()},
                          {400, 400}};
    const PictureCamera camera = pictureCamera(view, points, kAspect);
    QVERIFY((camera.pivot - view.camera.pivot).norm() < 0.02);
    QVERIFY(camera.viewAngle > CameraView::kAngle && camera.viewAngle < 1.25 * CameraView::kAngle);
  }

  void theNewestComesFirst() {
    const VariantList list = variants(6);
    VariantPictures pictures;
    pictures.setCamera(cameraOf(list));
    bool inOrder = true;
    connect(&pictures, &VariantPictures::drawn, this, [&] {
      bool later = true;
      for (auto variant = list.rbegin(); variant != list.rend(); ++variant) {
        const bool there = !pictures.shown(**variant).picture.isNull();
        inOrder = inOrder && (later || !there);
        later = there;
      }
    });
    pictures.request(list, nullptr);
    QCOMPARE(pictures.missing(), 6);
    QVERIFY(settle(pictures));
    QVERIFY(inOrder);
    QVERIFY(pictures.shown(*list[0]).picture != pictures.shown(*list[5]).picture);
    // Nothing is left to be asked for.
    pictures.request(list, nullptr);
    QCOMPARE(pictures.missing(), 0);
  }

  void variantsOfTheSameFusionsShareAPicture() {
    Document document = samples::documentOf(samples::fusion("fig4c_cone_sphere"));
    document = edits::addVariant(edits::addVariant(std::move(document), 1), 1);
    VariantPictures pictures;
    pictures.setCamera(cameraOf(document.variants));
    pictures.request(document.variants, nullptr);
    QCOMPARE(pictures.missing(), 1);
    QVERIFY(settle(pictures));
    QCOMPARE(pictures.shown(*document.variants[0]).picture.cacheKey(),
             pictures.shown(*document.variants[1]).picture.cacheKey());
  }

  void withoutACameraNothingIsAskedFor() {
    const VariantList list = variants(2);
    VariantPictures pictures;
    pictures.request(list, nullptr);
    QCOMPARE(pictures.missing(), 0);
  }

  void cancelForgetsAndTheNextRequestGoesOn() {
    const VariantList list = variants(20);
    VariantPictures pictures;
    pictures.setCamera(cameraOf(list));
    pictures.request(list, nullptr);
    pictures.cancel();
    QCOMPARE(pictures.missing(), 0);
    pictures.request(list, nullptr);
    QVERIFY(pictures.missing() > 0);
    QVERIFY(settle(pictures));
    for (const auto& variant : list) {
      QVERIFY(!pictures.shown(*variant).picture.isNull());
    }
  }

  void anotherCameraOrBackgroundDrawsThemAnew() {
    const VariantList list = variants(1);
    VariantPictures pictures;
    PictureCamera camera = cameraOf(list);
    pictures.setCamera(camera);
    pictures.request(list, nullptr);
    QVERIFY(settle(pictures));
    const QImage first = pictures.shown(*list[0]).picture;
    pictures.setDark(true);
    // The old one is shown until the new one is there.
    QCOMPARE(pictures.shown(*list[0]).picture, first);
    pictures.request(list, nullptr);
    QVERIFY(settle(pictures));
    const QImage dark = pictures.shown(*list[0]).picture;
    QVERIFY(dark.pixelColor(2, 2).lightness() < first.pixelColor(2, 2).lightness());
    camera.viewAngle *= 2;
    pictures.setCamera(camera);
    pictures.request(list, nullptr);
    QVERIFY(settle(pictures));
    QVERIFY(pictures.shown(*list[0]).picture != dark);
  }

  void filesComeBackAndADamagedOneIsDrawnAnew() {
    const VariantList list = variants(3);
    VariantPictures pictures;
    pictures.setCamera(cameraOf(list));
    pictures.request(list, nullptr);
    QVERIFY(settle(pictures));
    std::vector<QImage> before;
    for (const auto& variant : list) {
      before.push_back(pictures.shown(*variant).picture);
    }
    std::map<VariantId, std::string> files = pictures.files(list);
    QCOMPARE(files.size(), std::size_t{3});
    files[2] = "no picture";
    VariantPictures again;
    again.restore(list, files);
    again.restoreLook(pictures.camera(), false);
    again.request(list, nullptr);
    QCOMPARE(again.missing(), 3);
    QVERIFY(settle(again));
    for (std::size_t i = 0; i < list.size(); ++i) {
      QCOMPARE(again.shown(*list[i]).picture, before[i]);
    }
  }

  void aDamagedFileWithoutACameraLeavesNoPicture() {
    const VariantList list = variants(1);
    VariantPictures pictures;
    pictures.restore(list, {{list.front()->id, "no picture"}});
    pictures.request(list, nullptr);
    QVERIFY(settle(pictures));
    QVERIFY(pictures.shown(*list.front()).picture.isNull());
    QVERIFY(pictures.files(list).empty());
    pictures.request(list, nullptr);
    QCOMPARE(pictures.missing(), 0);
  }
};

QTEST_MAIN(VariantPicturesTest)
#include "variant_pictures_test.moc"
