#include <png.h>

#include <QtTest>
#include <numbers>
#include <random>
#include <thread>

#include "core/picture/corner_normals.h"
#include "core/picture/draw.h"
#include "core/picture/fusion_view.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"

using namespace graftsman;

namespace {

constexpr Colour kRed = {220, 30, 30};
constexpr Colour kBlue = {30, 30, 220};

// From the front, along +y.
const ViewDirection kFront = {{0, -1, 0}, {0, 0, 1}};

PictureShading plain() {
  PictureShading shading;
  shading.shadows = false;
  return shading;
}

// Each quad a square of side 2 about the origin in the plane y = depth.
struct Quads {
  std::vector<Point> points;
  std::vector<Face> faces;
  std::vector<Colour> colours;

  void add(double depth, const Colour& colour) {
    const auto first = static_cast<Index>(points.size());
    points.insert(points.end(), {{-1, depth, -1}, {1, depth, -1}, {1, depth, 1}, {-1, depth, 1}});
    faces.push_back({first, first + 1, first + 2});
    faces.push_back({first, first + 2, first + 3});
    colours.insert(colours.end(), 4, colour);
  }
};

bool isBackground(const Picture& picture, int x, int y) {
  const Picture empty = draw({}, {}, {}, picture.size);
  return picture.at(x, y) == empty.at(0, y);
}

int backgroundPixels(const Picture& picture) {
  const Picture empty = draw({}, {}, {}, picture.size);
  int count = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    count += picture.pixels[i] == empty.pixels[i] ? 1 : 0;
  }
  return count;
}

// Where the picture shows p: −1 … 1 from edge to edge.
Eigen::Vector2d placeOf(const Point& p, const PictureCamera& camera, double aspect) {
  const ViewFrame frame = viewFrame(camera);
  const Eigen::Vector3d d = p - camera.position;
  const double half = std::tan(camera.viewAngle / 2);
  return {frame.right.dot(d) / frame.into.dot(d) / half / aspect, frame.up.dot(d) / frame.into.dot(d) / half};
}

Picture decoded(const std::string& bytes) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) {
    return {};
  }
  image.format = PNG_FORMAT_RGB;
  Picture picture;
  picture.size = {static_cast<int>(image.width), static_cast<int>(image.height)};
  picture.pixels.resize(std::size_t{image.width} * image.height);
  return png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr) == 0 ? Picture() : picture;
}

}  // namespace

class PictureTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void withoutFacesThereIsTheGradientAlone() {
    const PictureShading shading;
    const Picture picture = draw({}, {}, {}, {40, 30}, shading);
    QCOMPARE(picture.pixels.size(), std::size_t{1200});
    QVERIFY(picture.at(0, 0) == shading.backgroundTop && picture.at(39, 0) == shading.backgroundTop);
    QVERIFY(picture.at(0, 29) == shading.backgroundBottom);
    for (int y = 1; y < 30; ++y) {
      QVERIFY(picture.at(7, y)[0] <= picture.at(7, y - 1)[0]);
    }
  }

  void whatIsNearerHidesWhatIsBehind() {
    for (const bool redFirst : {true, false}) {
      Quads quads;
      quads.add(redFirst ? 0 : 1, redFirst ? kRed : kBlue);
      quads.add(redFirst ? 1 : 0, redFirst ? kBlue : kRed);
      PictureShading shading = plain();
      shading.vertexColours = quads.colours;
      const Picture picture =
          draw(quads.points, quads.faces, frame(quads.points, kFront, 1), {64, 64}, shading);
      const Colour& middle = picture.at(32, 32);
      QVERIFY(middle[0] > 2 * middle[2]);
    }
  }

  void bothSidesAreDrawnAlike() {
    Quads quads;
    quads.add(0, kRed);
    const PictureCamera camera = frame(quads.points, {{0.3, -1, 0.2}}, 1);
    const Picture front = draw(quads.points, quads.faces, camera, {64, 64});
    for (Face& face : quads.faces) {
      std::swap(face[0], face[1]);
    }
    QVERIFY(draw(quads.points, quads.faces, camera, {64, 64}).pixels == front.pixels);
    QVERIFY(!isBackground(front, 32, 32));
  }

  void coloursAreInterpolatedBetweenVertices() {
    Quads quads;
    quads.add(0, kRed);
    quads.colours[1] = quads.colours[2] = kBlue;  // the right edge
    PictureShading shading = plain();
    shading.vertexColours = quads.colours;
    const Picture picture =
        draw(quads.points, quads.faces, frame(quads.points, kFront, 1), {65, 65}, shading);
    for (int x = 5; x < 60; ++x) {
      QVERIFY(picture.at(x, 20)[0] <= picture.at(x - 1, 20)[0] + (x == 5 ? 255 : 0));
    }
    const Colour& middle = picture.at(32, 32);
    QVERIFY(std::abs(middle[0] - middle[2]) < 12);
  }

  // Perspective: of a plane that runs away from the camera, the middle is not where the middle of the picture
  // of its edges is.
  void coloursFollowThePerspective() {
    const std::vector<Point> points = {{-1, 0, 0}, {1, 0, 0}, {1, 8, 0}, {-1, 8, 0}};
    const std::vector<Face> faces = {{0, 1, 2}, {0, 2, 3}};
    const std::vector<Colour> colours = {kRed, kRed, kBlue, kBlue};
    PictureShading shading = plain();
    shading.vertexColours = colours;
    const PictureCamera camera = frame(points, {{0, -1, 0.5}}, 1);
    const Picture picture = draw(points, faces, camera, {200, 200}, shading);
    const Eigen::Vector2d middle = placeOf({0, 4, 0}, camera, 1);
    const Colour& there = picture.at(100, static_cast<int>(100 - 100 * middle.y()));
    QVERIFY(std::abs(there[0] - there[2]) < 20);
  }

  void aFineMeshHasNoGaps() {
    const auto grid = shapes::grid(150);
    std::vector<Point> points = grid->points();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(-0.002, 0.002);
    for (Point& p : points) {
      p += Point(jitter(random), jitter(random), 0);
    }
    PictureCamera camera = frame(points, {{0, 0, 1}, {0, 1, 0}}, 1);
    camera.position = camera.pivot + 0.7 * (camera.position - camera.pivot);
    for (const PictureSize size : {PictureSize{97, 97}, PictureSize{400, 400}}) {
      QCOMPARE(backgroundPixels(draw(points, grid->faces(), camera, size)), 0);
    }
  }

  void facesThroughTheCameraAreCutOff() {
    const auto sphere = shapes::icosphere(1);
    PictureCamera inside;
    inside.position = {0.1, 0, 0};
    inside.pivot = {0.1, 0.5, 0.1};
    inside.viewAngle = 2;
    QCOMPARE(backgroundPixels(draw(sphere->points(), sphere->faces(), inside, {80, 60})), 0);
    // One large triangle that begins in front of the camera and ends behind it.
    const std::vector<Point> points = {{-50, -20, -1}, {50, -20, -1}, {0, 60, -1}};
    const std::vector<Face> faces = {{0, 1, 2}};
    const Picture floor = draw(points, faces, {{0, 0, 0}, {0, 1, 0}}, {60, 60});
    QVERIFY(isBackground(floor, 30, 5));
    QVERIFY(!isBackground(floor, 30, 57));
  }

  void anEdgeOfTheShapeIsSmooth() {
    const auto sphere = shapes::icosphere(4);
    const Picture picture =
        draw(sphere->points(), sphere->faces(), frame(sphere->points(), kFront, 1), {64, 64}, plain());
    std::size_t tones = 0;
    for (int y = 0; y < 64; ++y) {
      for (int x = 1; x < 63; ++x) {
        const int left = picture.at(x - 1, y)[1];
        const int right = picture.at(x + 1, y)[1];
        const int here = picture.at(x, y)[1];
        tones += std::abs(left - right) > 60 && here > std::min(left, right) && here < std::max(left, right);
      }
    }
    QVERIFY(tones > 10);
  }

  void shadowsDarkenAHollow() {
    // A pit in the middle of a plate.
    const auto plate = shapes::grid(40);
    const std::vector<Face>& faces = plate->faces();
    std::vector<Point> points = plate->points();
    for (Point& p : points) {
      const double r = std::hypot(p.x() - 0.5, p.y() - 0.5);
      p.z() = r < 0.08 ? -0.15 : 0;
    }
    const PictureCamera camera = frame(points, {{0, 0, 1}, {0, 1, 0}}, 1);
    const Picture with = draw(points, faces, camera, {100, 100});
    const Picture without = draw(points, faces, camera, {100, 100}, plain());
    QVERIFY(with.at(50, 50)[0] + 10 < without.at(50, 50)[0]);
    QVERIFY(std::abs(with.at(15, 50)[0] - without.at(15, 50)[0]) <= 3);
  }

  void aBoxKeepsItsEdgesAndABallHasNone() {
    const std::vector<Point> corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                        {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    const std::vector<Face> faces = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                     {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    const auto box = picture_detail::cornerNormals(corners, faces, 0.8);
    for (std::size_t f = 0; f < faces.size(); ++f) {
      for (const Index n : box.corners[f]) {
        const Eigen::Vector3f& normal = box.normals[static_cast<std::size_t>(n)];
        QVERIFY(std::abs(normal.cwiseAbs().maxCoeff() - 1) < 1e-6F);
      }
    }
    const auto sphere = shapes::icosphere(3);
    const auto ball = picture_detail::cornerNormals(sphere->points(), sphere->faces(), 0.8);
    QCOMPARE(ball.normals.size(), sphere->points().size());
    for (std::size_t v = 0; v < ball.normals.size(); ++v) {
      QVERIFY(ball.normals[v].cast<double>().dot(sphere->points()[v]) > 0.999);
    }
  }

  void normalsDoNotDependOnTheUnit() {
    const auto torus = shapes::torus(9, 7);
    const auto expected = picture_detail::cornerNormals(torus->points(), torus->faces(), 0.8);
    for (const double unit : {1e-60, 1e60}) {
      std::vector<Point> points = torus->points();
      for (Point& p : points) {
        p *= unit;
      }
      const auto normals = picture_detail::cornerNormals(points, torus->faces(), 0.8);
      QVERIFY(normals.corners == expected.corners);
      for (std::size_t i = 0; i < normals.normals.size(); ++i) {
        QVERIFY((normals.normals[i] - expected.normals[i]).norm() < 1e-5F);
      }
    }
  }

  void framingShowsAllWithoutWaste() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<Point> points;
      for (int i = 0; i < 50; ++i) {
        points.emplace_back(1e3 + 3 * unit(random), unit(random), -50 + 2 * unit(random));
      }
      const double aspect = 4.0 / 3;
      const ViewDirection direction = {{unit(random), unit(random), unit(random)},
                                       {unit(random), unit(random), unit(random)}};
      const PictureCamera camera = frame(points, direction, aspect);
      Eigen::Array2d low(1, 1);
      Eigen::Array2d high(-1, -1);
      for (const Point& p : points) {
        const Eigen::Array2d place = placeOf(p, camera, aspect).array();
        low = low.min(place);
        high = high.max(place);
      }
      constexpr double kEdge = 0.88;
      QVERIFY(low.minCoeff() > -kEdge - 1e-9 && high.maxCoeff() < kEdge + 1e-9);
      // The tighter direction touches both edges, the other lies in the middle between them.
      const Eigen::Array2d span = high - low;
      QVERIFY(std::abs(span.maxCoeff() - 2 * kEdge) < 1e-9);
      QVERIFY((camera.position - camera.pivot).normalized().dot(direction.towards.normalized()) > 1 - 1e-12);
    }
  }

  void aBoxIsFramedByItsCorners() {
    const PictureCamera camera = frameBox({0, 0, 0}, {2, 1, 1}, kFront, 1);
    QVERIFY((placeOf({0, 0, 0}, camera, 1) - Eigen::Vector2d(-0.88, -0.44)).norm() < 1e-12);
    QVERIFY((placeOf({2, 0, 1}, camera, 1) - Eigen::Vector2d(0.88, 0.44)).norm() < 1e-12);
  }

  void aLonePointAndAnOddDirectionAreFramed() {
    const std::vector<Point> point = {{5, 5, 5}};
    for (const ViewDirection& direction :
         {ViewDirection{}, ViewDirection{{0, 0, 1}, {0, 0, 1}}, ViewDirection{{0, 0, 0}, {0, 0, 0}}}) {
      const PictureCamera camera = frame(point, direction, 1);
      QVERIFY(camera.position.allFinite() && (camera.position - camera.pivot).norm() > 0);
      const ViewFrame axes = viewFrame(camera);
      QVERIFY(std::abs(axes.right.dot(axes.up)) < 1e-12 && std::abs(axes.up.norm() - 1) < 1e-12);
    }
  }

  void aTurntableGoesRoundAtOneDistance() {
    const auto torus = shapes::torus(20, 10);
    const std::vector<PictureCamera> cameras = turntable(torus->points(), {{0.3, -1, 0.4}}, 1.5, 12);
    QCOMPARE(cameras.size(), std::size_t{12});
    for (std::size_t i = 0; i < cameras.size(); ++i) {
      QVERIFY(std::abs((cameras[i].position - cameras[i].pivot).norm() -
                       (cameras[0].position - cameras[0].pivot).norm()) < 1e-12);
      QVERIFY(std::abs(cameras[i].position.z() - cameras[0].position.z()) < 1e-12);
      const Point& next = cameras[(i + 1) % 12].position;
      QVERIFY(std::abs((next - cameras[i].position).norm() -
                       (cameras[1].position - cameras[0].position).norm()) < 1e-12);
      for (const Point& p : torus->points()) {
        QVERIFY(placeOf(p, cameras[i], 1.5).cwiseAbs().maxCoeff() < 0.88 + 1e-9);
      }
    }
  }

  void theSamePixelsOnAnyThread() {
    const auto torus = shapes::torus(60, 40);
    const PictureCamera camera = frame(torus->points(), {{0.3, -1, 0.8}}, 4.0 / 3);
    const auto make = [&] { return draw(torus->points(), torus->faces(), camera, {128, 96}); };
    const Picture here = make();
    std::array<Picture, 3> there;
    {
      std::vector<std::jthread> threads;
      for (Picture& picture : there) {
        threads.emplace_back([&] { picture = make(); });
      }
    }
    for (const Picture& picture : there) {
      QVERIFY(picture.pixels == here.pixels);
    }
  }

  void aPngHoldsThePixels() {
    const auto torus = shapes::torus(30, 20);
    const Picture picture = draw(torus->points(), torus->faces(), frame(torus->points(), {}, 1.2), {61, 50});
    const std::string bytes = formatPng(picture).value();
    const Picture back = decoded(bytes);
    QVERIFY(back.size == picture.size && back.pixels == picture.pixels);
    QVERIFY(formatPng(picture).value() == bytes);
  }

  void aFusionIsSeenInBothItsShapes() {
    for (const std::string& name : samples::kScenarios) {
      const FusionResults results = update(samples::load(name), {}, {});
      const ViewDirection direction = firstDirection(results.inputs, false);
      const double aspect = 4.0 / 3;
      for (const FusionView view : {FusionView::Whole, FusionView::Tile}) {
        const PictureCamera camera = cameraFor(results, view, direction, aspect);
        for (const auto* points : {&results.combined->base, &results.combined->part}) {
          for (const Point& p : *points) {
            QVERIFY2(placeOf(p, camera, aspect).cwiseAbs().maxCoeff() < 1, name.c_str());
          }
        }
      }
    }
  }

  void aTileIsSeenFromOutside() {
    const FusionInputs inputs = samples::load("fig8b_cone_nose");
    const ViewDirection direction = firstDirection(inputs, true);
    // The face looks along +z, y is up.
    QVERIFY(direction.towards.normalized().z() > 0.5);
    QVERIFY(direction.up == Eigen::Vector3d::UnitY());
    const FusionResults results = update(inputs, {}, {});
    const auto distance = [&](FusionView view) {
      const PictureCamera camera = cameraFor(results, view, direction, 1);
      return (camera.position - camera.pivot).norm();
    };
    QVERIFY(distance(FusionView::Tile) < 0.6 * distance(FusionView::Whole));
  }

  void aFusionThatFailedIsFramedByItsLoop() {
    FusionInputs inputs = samples::load("fig8b_cone_nose");
    inputs.loop.resize(2);
    const FusionResults results = update(inputs, {}, {});
    QVERIFY(results.error && !results.combined);
    const PictureCamera camera = cameraFor(results, FusionView::Whole, firstDirection(inputs, true), 1);
    for (const Point& p : inputs.base->points()) {
      QVERIFY(placeOf(p, camera, 1).cwiseAbs().maxCoeff() < 0.88 + 1e-9);
    }
  }

  void aMorphEndsInBothShapes() {
    const FusionResults results = update(samples::load("fig8c_cone_nose"), {}, {});
    QVERIFY(morphed(results, 0) == results.join->points);
    const std::vector<Point> part = morphed(results, 1);
    const std::vector<Point> half = morphed(results, 0.5);
    for (std::size_t i = 0; i < results.combined->part.size(); ++i) {
      const auto v = static_cast<std::size_t>(results.join->tileVertices[i]);
      QVERIFY(part[v] == results.combined->part[i]);
      QVERIFY((half[v] - (results.combined->part[i] + results.combined->base[i]) / 2).norm() < 1e-12);
    }
  }
};

QTEST_APPLESS_MAIN(PictureTest)
#include "picture_test.moc"
