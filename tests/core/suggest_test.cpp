#include <QtTest>
#include <set>
#include <span>

#include "core/base/parallel.h"
#include "core/sweep/suggest.h"
#include "core/sweep/tile_samples.h"
#include "tests/support/samples.h"
#include "tests/support/steps.h"

using namespace graftsman;

namespace {

constexpr std::array kOrders = {SuggestionOrder::MeanSeamAngle, SuggestionOrder::GreatestSeamAngle,
                                SuggestionOrder::LeastDistance, SuggestionOrder::GreatestDistance,
                                SuggestionOrder::Quality};

Result<Suggestions> suggestFor(const FusionInputs& inputs, const Progress& progress = {}) {
  return suggest(update(inputs, {}, {}), NearestSurface(inputs.base), progress);
}

bool identical(const Suggestions& a, const Suggestions& b) {
  if (a.candidates.size() != b.candidates.size() || a.tried != b.tried || a.differences != b.differences) {
    return false;
  }
  return std::equal(a.candidates.begin(), a.candidates.end(), b.candidates.begin(),
                    [](const Suggestion& x, const Suggestion& y) {
                      return x.inputs.fcf == y.inputs.fcf && x.inputs.adjustment == y.inputs.adjustment &&
                             x.inputs.loop == y.inputs.loop && x.preset == y.preset && x.height == y.height &&
                             x.shift == y.shift && x.changes == y.changes && x.measures == y.measures;
                    });
}

// Candidates on a line, each as far from the next as `step`, the first with the smallest angle.
Suggestions onALine(std::size_t count, double step) {
  Suggestions suggestions;
  suggestions.tried = count;
  suggestions.candidates.resize(count);
  const auto size = static_cast<Eigen::Index>(count);
  suggestions.differences = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 0; i < size; ++i) {
    suggestions.candidates[static_cast<std::size_t>(i)].measures.meanSeamAngle = static_cast<double>(i);
    for (Eigen::Index j = 0; j < size; ++j) {
      suggestions.differences(i, j) = step * static_cast<double>(std::abs(i - j));
    }
  }
  return suggestions;
}

std::vector<std::size_t> chosenOf(const Suggestions& suggestions) {
  return choose(suggestions, SuggestionOrder::MeanSeamAngle);
}

}  // namespace

class SuggestTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cleanup() { setThreadCount(0); }

  void everySampleHasSixToNineSuggestionsThatDifferAndFuse() {
    const auto share = static_cast<std::size_t>(steps(static_cast<int>(samples::kScenarios.size())));
    for (const std::string& name : std::span(samples::kScenarios).last(share)) {
      const FusionInputs inputs = samples::load(name);
      const FusionResults present = update(inputs, {}, {});
      const NearestSurface base(inputs.base);
      const Result<Suggestions> suggestions = suggest(present, base, {});
      QVERIFY2(suggestions, name.c_str());
      QVERIFY(suggestions->tried < kMostSettingsTried);
      for (const SuggestionOrder order : kOrders) {
        const std::vector<std::size_t> chosen = choose(*suggestions, order);
        QVERIFY2(chosen.size() >= kFewestSuggestions && chosen.size() <= kMostSuggestions,
                 qPrintable(QString("%1: %2").arg(name.c_str()).arg(chosen.size())));
        for (const std::size_t i : chosen) {
          const Suggestion& suggestion = suggestions->candidates[i];
          for (const std::size_t j : chosen) {
            QVERIFY(i == j || suggestions->differences(static_cast<Eigen::Index>(i),
                                                       static_cast<Eigen::Index>(j)) >= kLookAlike);
          }
          QVERIFY(suggestion.inputs.part == inputs.part && suggestion.inputs.base == inputs.base);
          QVERIFY(suggestion.changes > 0);
        }
      }
      // What is measured and offered is what fusing afresh gives.
      const Suggestion& first = suggestions->candidates[chosenOf(*suggestions).back()];
      const FusionResults afresh = update(first.inputs, {}, {});
      QVERIFY(afresh.fused && !afresh.error);
      QVERIFY(*measure(afresh, base, {}) == first.measures);
    }
  }

  void theyAreTheSameBitsOnAnyNumberOfThreadsAndWhateverIsKnown() {
    const FusionInputs inputs = samples::load("fig9b_bird_plane");
    const NearestSurface base(inputs.base);
    const Result<Suggestions> first = suggestFor(inputs);
    setThreadCount(3);
    QVERIFY(identical(*first, *suggestFor(inputs)));
    setThreadCount(1);
    FusionResults nothing;
    nothing.inputs = inputs;
    QVERIFY(identical(*first, *suggest(nothing, base, {})));
  }

  void theBestComesFirstByEachMeasure() {
    const Suggestions suggestions = suggestFor(samples::load("fig8b_cone_nose")).value();
    for (const SuggestionOrder order : kOrders) {
      const bool greatestFirst =
          order == SuggestionOrder::GreatestDistance || order == SuggestionOrder::Quality;
      const std::vector<std::size_t> chosen = choose(suggestions, order);
      for (std::size_t i = 1; i < chosen.size(); ++i) {
        const double before = measureOf(suggestions.candidates[chosen[i - 1]].measures, order);
        const double after = measureOf(suggestions.candidates[chosen[i]].measures, order);
        QVERIFY(greatestFirst ? before >= after : before <= after);
      }
    }
    QVERIFY(choose(suggestions, SuggestionOrder::LeastDistance) !=
            choose(suggestions, SuggestionOrder::GreatestDistance));
  }

  void noneLooksLikeThePresentResult() {
    const FusionInputs inputs = samples::load("fig4c_cone_sphere");
    const FusionResults present = update(inputs, {}, {});
    const Suggestions suggestions = suggestFor(inputs).value();
    TileSamples samples(*present.combined, 256);
    const std::vector<Point> now = samples.positions(present);
    const double unit = samples.partDistance(present);
    for (const std::size_t i : chosenOf(suggestions)) {
      const FusionResults other = update(suggestions.candidates[i].inputs, present, {});
      QVERIFY(rootMeanSquareDistance(now, samples.positions(other)) > 0.9 * kLookAlike * unit);
    }
  }

  void samplesOfATileAreItsVertices() {
    const FusionResults results = update(samples::load("fig8d_hemisphere_nose"), {}, {});
    TileSamples all(*results.combined, results.combined->uv.size());
    const std::vector<Point> found = all.positions(results);
    QCOMPARE(found.size(),
             results.combined->uv.size() - static_cast<std::size_t>(results.combined->seamSize));
    const auto less = [](const Point& a, const Point& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::set<Point, decltype(less)> vertices(less);
    for (const Index v : results.join->tileVertices) {
      vertices.insert(results.fused->points[static_cast<std::size_t>(v)]);
    }
    std::size_t near = 0;
    for (const Point& point : found) {
      const auto at = vertices.lower_bound(point - Point::Constant(1e-9));
      near += at != vertices.end() && (*at - point).norm() < 1e-8 ? 1 : 0;
    }
    QVERIFY2(near > found.size() * 9 / 10, qPrintable(QString("%1 of %2").arg(near).arg(found.size())));
  }

  // The part's loop is turned by two CVs: that turned back fits as well as the sample does.
  void aShiftThatFitsBetterIsFound() {
    FusionInputs inputs = samples::load("fig7_letters_bottle");
    const Loop loop = inputs.loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      inputs.loop[(i + 2) % loop.size()].part = loop[i].part;
    }
    const Suggestions suggestions = suggestFor(inputs).value();
    QVERIFY(std::ranges::any_of(suggestions.candidates, [&](const Suggestion& suggestion) {
      return suggestion.shift == -2 && suggestion.inputs.loop == loop;
    }));
  }

  void aStepThatIsOffIsTurnedOnInSome() {
    FusionInputs inputs = samples::load("fig8d_hemisphere_nose");
    inputs.adjustment.exactFit = false;
    const Suggestions suggestions = suggestFor(inputs).value();
    for (const bool exact : {false, true}) {
      QVERIFY(std::ranges::any_of(suggestions.candidates, [&](const Suggestion& suggestion) {
        return suggestion.inputs.adjustment.exactFit == exact;
      }));
    }
  }

  void aLoopThatFailsIsTheError() {
    FusionInputs inputs = samples::load("fig4a_cone_sphere");
    inputs.loop[1].base = inputs.loop[0].base;
    const Result<Suggestions> suggestions = suggestFor(inputs);
    QVERIFY(!suggestions);
    QCOMPARE(suggestions.error().code, ErrorCode::LoopRepeatsPoint);
  }

  // An ε that is none fails with the settings as they are, and with every other of them.
  void whereNothingFusesThereIsNothingToChoose() {
    FusionInputs inputs = samples::load("fig4a_cone_sphere");
    inputs.adjustment.epsilon = -1;
    const Suggestions suggestions = suggestFor(inputs).value();
    QVERIFY(suggestions.tried > 0);
    QVERIFY(suggestions.candidates.empty());
    QVERIFY(chosenOf(suggestions).empty());
  }

  // A falloff that is none fails as it is; those that are tried instead do not.
  void whatFailsIsLeftOutAndTheOthersAreOffered() {
    FusionInputs inputs = samples::load("fig8d_hemisphere_nose");
    inputs.adjustment.falloff = -1;
    QVERIFY(update(inputs, {}, {}).error);
    const Suggestions suggestions = suggestFor(inputs).value();
    QVERIFY(!suggestions.candidates.empty());
    for (const Suggestion& suggestion : suggestions.candidates) {
      QVERIFY(suggestion.inputs.adjustment.falloff > 0);
    }
    QVERIFY(suggestions.candidates.size() < suggestions.tried);
    QVERIFY(chosenOf(suggestions).size() >= kFewestSuggestions);
  }

  void aFusionWhosePartIsItsBaseHasNoneThatDiffers() {
    FusionInputs inputs = samples::load("fig8b_cone_nose");
    inputs.part = inputs.base;
    for (CVP& pair : inputs.loop) {
      pair.part = pair.base;
    }
    inputs.adjustment.maxIterations = 1;
    const Suggestions suggestions = suggestFor(inputs).value();
    for (const Suggestion& suggestion : suggestions.candidates) {
      QVERIFY(suggestion.shift != 0);  // whatever the curve and the adjustment, it is the base
    }
  }

  void cancelledAtAnyCallItSaysSo() {
    const FusionInputs inputs = samples::load("fig4a_cone_sphere");
    const FusionResults present = update(inputs, {}, {});
    const NearestSurface base(inputs.base);
    int calls = 0;
    double last = 0;
    const Result<Suggestions> whole = suggest(present, base,
                                              Progress(
                                                  [&](double done) {
                                                    ++calls;
                                                    last = done;
                                                    return true;
                                                  },
                                                  std::chrono::seconds(0)));
    QVERIFY(whole);
    QVERIFY(calls > 100);
    QVERIFY(last > 0.9);
    for (int k = 1; k <= calls; k += 1 + calls / steps(40)) {
      int left = k;
      const Result<Suggestions> stopped =
          suggest(present, base, Progress([&](double) { return --left > 0; }, std::chrono::seconds(0)));
      QVERIFY2(!stopped, qPrintable(QString("stopped at call %1 of %2").arg(k).arg(calls)));
      QCOMPARE(stopped.error().code, ErrorCode::Cancelled);
    }
    QVERIFY(identical(*whole, *suggest(present, base, {})));
  }

  void thoseThatAreChosenAreAsFarApartAsNineCanBe() {
    // 100 candidates on a line, 0.05 from one to the next: of the best three quarters, nine at 0.45.
    const std::vector<std::size_t> chosen = chosenOf(onALine(100, 0.05));
    QCOMPARE(chosen, (std::vector<std::size_t>{0, 9, 18, 27, 36, 45, 54, 63, 72}));
  }

  void whereFewDifferTheWorstAreAskedAsWellAndFewComeBack() {
    // Of sixteen, in steps of 0.025, every third differs.
    QCOMPARE(chosenOf(onALine(16, 0.025)), (std::vector<std::size_t>{0, 3, 6, 9, 12, 15}));
    QCOMPARE(chosenOf(onALine(5, 0.01)), std::vector<std::size_t>{0});
    QVERIFY(chosenOf(Suggestions()).empty());
  }

  void ofEquallyGoodOnesThatWithFewerChangesIsTaken() {
    Suggestions suggestions = onALine(3, 0);
    suggestions.candidates[0].changes = 2;
    suggestions.candidates[1].changes = 1;
    suggestions.candidates[1].measures.meanSeamAngle = 0.001;
    QCOMPARE(chosenOf(suggestions), std::vector<std::size_t>{1});
  }
};

QTEST_GUILESS_MAIN(SuggestTest)
#include "suggest_test.moc"
