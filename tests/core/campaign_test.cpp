// The seeded campaign: random loops on random pairs of models with random curves. Every outcome is a result
// that holds the invariants, or a documented error; the share of each is printed.

#include <Eigen/Geometry>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "core/fusion/update.h"
#include "core/fusion/verify.h"
#include "tests/support/samples.h"
#include "tests/support/shapes.h"

using namespace graftsman;

namespace {

constexpr int kLoops = 500;
constexpr std::uint32_t kSeed = 19990131;

struct NamedMesh {
  std::string name;
  std::shared_ptr<const TriangleMesh> mesh;
};

// std::uniform_int_distribution differs between libraries; this does not.
class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}
  Index below(Index n) { return static_cast<Index>(engine_() % static_cast<std::uint32_t>(n)); }
  double unit() { return engine_() / 4294967296.0; }

 private:
  std::mt19937 engine_;
};

std::vector<NamedMesh> meshes() {
  std::vector<NamedMesh> all;
  for (const std::string& name : samples::kModels) {
    if (name != "nefertiti.ply") {  // its turn comes in the benchmarks: here it would only be slow
      all.push_back({name, samples::model(name)});
    }
  }
  all.push_back({"torus", shapes::torus(40, 20)});
  all.push_back({"icosphere", shapes::icosphere(3)});
  all.push_back({"grid", shapes::grid(30)});
  return all;
}

Point normalAt(const TriangleMesh& mesh, Index v) {
  Point sum = Point::Zero();
  const Index first = mesh.outgoing(v);
  for (Index h = first; h >= 0;) {
    const Point& a = mesh.point(mesh.from(h));
    sum += (mesh.point(mesh.to(h)) - a).cross(mesh.point(mesh.from(TriangleMesh::prev(h))) - a);
    h = mesh.twin(TriangleMesh::prev(h));
    if (h == first) {
      break;
    }
  }
  return sum;
}

// n vertices round a random one, in order of their angle about its normal: mostly a counter-clockwise loop.
// Where the surface is too small or too folded for that, the loops come out wild, which is wanted, too.
std::vector<Index> roundLoop(const TriangleMesh& mesh, int n, Random& random) {
  Index centre = random.below(mesh.vertexCount());
  while (mesh.singular(centre)) {
    centre = random.below(mesh.vertexCount());
  }
  const int rings = 2 + random.below(8);
  std::vector<bool> seen(mesh.points().size(), false);
  std::vector<Index> ring = {centre};
  seen[static_cast<std::size_t>(centre)] = true;
  for (int i = 0; i < rings || static_cast<int>(ring.size()) < 2 * n; ++i) {  // twice: no CV repeats
    std::vector<Index> next;
    for (const Index v : ring) {
      const Index first = mesh.outgoing(v);
      for (Index h = first; h >= 0;) {
        for (const Index w : {mesh.to(h), mesh.from(TriangleMesh::prev(h))}) {
          if (!seen[static_cast<std::size_t>(w)] && !mesh.singular(w)) {
            seen[static_cast<std::size_t>(w)] = true;
            next.push_back(w);
          }
        }
        h = mesh.twin(TriangleMesh::prev(h));
        if (h == first) {
          break;
        }
      }
    }
    if (next.empty()) {
      break;  // the whole component is reached
    }
    ring = next;
  }
  const Point normal = normalAt(mesh, centre).normalized();
  Point x = normal.unitOrthogonal();
  const Point y = normal.cross(x);
  std::vector<std::pair<double, Index>> byAngle;
  for (const Index v : ring) {
    const Point d = mesh.point(v) - mesh.point(centre);
    byAngle.emplace_back(std::atan2(d.dot(y), d.dot(x)), v);
  }
  std::sort(byAngle.begin(), byAngle.end());
  std::vector<Index> loop;
  const double start = random.unit();
  for (int i = 0; i < n; ++i) {
    const double at = (i + 0.4 * random.unit() + start) / n;
    loop.push_back(
        byAngle[static_cast<std::size_t>(std::fmod(at, 1.0) * static_cast<double>(byAngle.size()))].second);
  }
  return loop;
}

// One in ten: any vertices at all.
std::vector<Index> randomLoop(const TriangleMesh& mesh, int n, Random& random) {
  if (random.below(10) > 0) {
    return roundLoop(mesh, n, random);
  }
  std::vector<Index> loop;
  for (int i = 0; i < n; ++i) {
    loop.push_back(random.below(mesh.vertexCount()));
  }
  return loop;
}

FCF randomCurve(Random& random) {
  std::vector<FCFPoint> points;
  const int count = 4 + random.below(5);
  for (int i = 0; i < count; ++i) {
    points.push_back({static_cast<double>(i) / (count - 1), random.unit()});
  }
  return *FCF::through(std::move(points), random.below(2) == 0);
}

}  // namespace

class CampaignTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void everyRandomLoopGivesAValidResultOrADocumentedError() {
    Random random(kSeed);
    const std::vector<NamedMesh> all = meshes();
    std::map<std::string, int> outcomes;
    for (int i = 0; i < kLoops; ++i) {
      const NamedMesh& part = all[static_cast<std::size_t>(random.below(static_cast<Index>(all.size())))];
      const NamedMesh& base = all[static_cast<std::size_t>(random.below(static_cast<Index>(all.size())))];
      const int n = 3 + random.below(14);
      FusionInputs inputs;
      inputs.part = part.mesh;
      inputs.base = base.mesh;
      inputs.fcf = randomCurve(random);
      inputs.paths = random.below(4) == 0 ? PathMode::Paper : PathMode::Straightened;
      const std::vector<Index> partLoop = randomLoop(*part.mesh, n, random);
      const std::vector<Index> baseLoop = randomLoop(*base.mesh, n, random);
      for (int k = 0; k < n; ++k) {
        inputs.loop.push_back({SurfacePoint::atVertex(partLoop[static_cast<std::size_t>(k)]),
                               SurfacePoint::atVertex(baseLoop[static_cast<std::size_t>(k)])});
      }
      const QByteArray what = QString("loop %1: %2 on %3, %4 CVs")
                                  .arg(i)
                                  .arg(part.name.c_str(), base.name.c_str())
                                  .arg(n)
                                  .toUtf8();
      const FusionResults results = update(inputs, {}, {});
      if (results.error) {
        QVERIFY2(results.error->code != ErrorCode::Unexpected, what + ": " + results.error->message.c_str());
        QVERIFY2(!results.error->message.empty(), what);
        ++outcomes[std::string("error at ") + name(results.failedAt) + ", code " +
                   std::to_string(static_cast<int>(results.error->code))];
        continue;
      }
      const Verification verification = verify(results);
      QVERIFY2(verification.baseUnchanged(), what);
      QVERIFY2(verification.topologyKept(), what);
      QVERIFY2(verification.invertedFaces == 0, what);
      QVERIFY2(verification.holds(), what + QString(": distances %1 %2, area %3")
                                                .arg(verification.baseDistance)
                                                .arg(verification.partDistance)
                                                .arg(verification.embeddedAreaError)
                                                .toUtf8());
      ++outcomes["valid"];
    }
    for (const auto& [outcome, count] : outcomes) {
      qInfo("%5.1f %%  %s", 100.0 * count / kLoops, outcome.c_str());
    }
    QVERIFY2(outcomes["valid"] >= kLoops / 2, "most round loops are good ones");
  }
};

QTEST_APPLESS_MAIN(CampaignTest)
#include "campaign_test.moc"
