// What a frame of a mesh of a million faces costs the pane that shows it, with the machine's OpenGL: the
// first one, and one of an orbit. Needs a display.

#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <QtTest>
#include <chrono>

#include "core/base/large_array.h"
#include "tests/support/mesh_pane_shown.h"

namespace {

using namespace graftsman;

std::shared_ptr<const TriangleMesh> million() {
  static const shapes::MeshPtr kMesh = shapes::torus(720, 720);
  return kMesh;
}

struct BigPane {
  MeshPane pane{Side::Base};

  BigPane() {
    pane.resize(640, 700);
    pane.show();
    if (!QTest::qWaitForWindowExposed(&pane)) {
      qFatal("the pane is not exposed");
    }
    (void)pane.grabFramebuffer();
  }
  void show() {
    QSignalSpy shown(&pane, &MeshPane::meshShown);
    pane.setMesh(million());
    if (shown.isEmpty() && !shown.wait(60'000)) {
      qFatal("the mesh is not shown");
    }
  }
};

void firstFrame(benchmark::State& state) {
  for (auto _ : state) {
    BigPane big;
    big.show();
    const auto begun = std::chrono::steady_clock::now();
    (void)big.pane.grabFramebuffer();
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
  }
}

// `frame` draws the pane as it is seen from a new place.
template <class Frame>
void orbit(benchmark::State& state, const Frame& frame) {
  BigPane big;
  big.show();
  (void)big.pane.grabFramebuffer();
  QTest::mousePress(&big.pane, Qt::MiddleButton, {}, {300, 300});
  int x = 0;
  for (auto _ : state) {
    panes::moveHeld(big.pane, {300.0 + ++x, 300}, Qt::MiddleButton);
    frame(big.pane);
  }
  QTest::mouseRelease(&big.pane, Qt::MiddleButton, {}, {300 + x, 300});
}

void orbitOurs(benchmark::State& state) {
  orbit(state, [](MeshPane& pane) { (void)pane.grabFramebuffer(); });
}

void orbitAll(benchmark::State& state) {
  orbit(state, [](MeshPane& pane) { (void)pane.picture(); });
}

BENCHMARK(firstFrame)
    ->Name("Pane first frame/ours/1M")
    ->Unit(benchmark::kMillisecond)
    ->UseManualTime()
    ->Iterations(3);
BENCHMARK(orbitOurs)->Name("Pane orbit/ours/1M")->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(orbitAll)->Name("Pane orbit/all faces/1M")->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

int main(int argc, char** argv) {
  graftsman::keepFreedMemory();
  const QApplication app(argc, argv);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
