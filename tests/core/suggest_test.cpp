#include <QtTest>
#include <set>

#include "core/base/parallel.h"
#include "core/sweep/suggest.h"
#include "tests/support/samples.h"

using namespace graftsman;

namespace {

[[maybe_unused]] Result<Suggestions> suggestFor(const FusionInputs& inputs, const Progress& progress = {}) {
  return suggest(update(inputs, {}, {}), NearestSurface(inputs.base), progress);
}

void print(const char* title, const Suggestions& s, const FusionInputs&) {
  qInfo("%s: tried %zu, candidates %zu", title, s.tried, s.candidates.size());
  for (auto o : {SuggestionOrder::MeanSeamAngle, SuggestionOrder::GreatestDistance}) {
    qInfo(" order %d", int(o));
    for (auto i : choose(s, o)) {
      const auto& c = s.candidates[i];
      qInfo("  %zu preset %d h %g mono %d falloff %g shift %d seam %.2f dist %.3g q %.3g", i,
            c.preset ? int(*c.preset) : -1, c.height, c.inputs.fcf.monotone(), c.inputs.adjustment.falloff,
            c.shift, c.measures.meanSeamAngle * 57.3, c.measures.greatestDistance, c.measures.lowQuality);
    }
  }
}

}  // namespace

class SuggestTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void probe() {
    for (const auto& name : samples::kScenarios) {
      const FusionInputs in = samples::load(name);
      const FusionResults present = update(in, {}, {});
      NearestSurface near(in.base);
      QElapsedTimer t;
      t.start();
      auto s = suggest(present, near, {});
      if (!s) {
        qInfo("%s %s", name.c_str(), s.error().message.c_str());
        continue;
      }
      qInfo("%lld ms", t.elapsed());
      print(name.c_str(), *s, in);
    }
  }
};

QTEST_GUILESS_MAIN(SuggestTest)
#include "suggest_test.moc"
