#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "core/base/parallel.h"
#include "core/base/predicates.h"
#include "core/base/progress.h"
#include "core/base/write_file.h"

using namespace graftsman;
using namespace std::chrono_literals;

class BaseTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aDefaultProgressNeverStops() {
    const Progress progress;
    QVERIFY(progress.keepGoing(0.5));
    QVERIFY(!progress.cancelled());
  }

  void progressNeverFallsAndStaysInItsSpan() {
    std::vector<double> seen;
    const Progress progress([&](double done) { return seen.push_back(done), true; }, 0ns);
    const Progress half = progress.span(0.5, 1);
    QVERIFY(half.keepGoing(0.5));
    QVERIFY(progress.keepGoing(0.1));  // a late worker
    QVERIFY(half.span(0.5, 1).keepGoing(7));
    QCOMPARE(seen, (std::vector<double>{0.75, 0.75, 1}));
  }

  void aRefusedReportStopsEveryCopy() {
    int calls = 0;
    const Progress progress([&](double) { return ++calls < 2; }, 0ns);
    const Progress copy = progress.span(0, 0.5);
    QVERIFY(copy.keepGoing(0));
    QVERIFY(!copy.keepGoing(0.1));
    QVERIFY(progress.cancelled());
    QVERIFY(!progress.keepGoing(0.2));
    QCOMPARE(calls, 2);
  }

  void aLongIntervalReportsOnce() {
    int calls = 0;
    const Progress progress([&](double) { return ++calls > 0; }, 1h);
    for (int i = 0; i < 1000; ++i) {
      QVERIFY(progress.keepGoing(i / 1000.0));
    }
    QCOMPARE(calls, 1);
  }

  void everyIndexIsVisitedOnce() {
    for (const int threads : {1, 2, 5}) {
      setThreadCount(threads);
      std::vector<std::atomic<int>> visits(1001);
      parallelFor(visits.size(), [&](std::size_t i) { ++visits[i]; });
      parallelRanges(visits.size(), 10, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          ++visits[i];
        }
      });
      QVERIFY(std::all_of(visits.begin(), visits.end(), [](const auto& v) { return v == 2; }));
    }
    setThreadCount(0);
    QVERIFY(threadCount() >= 1);
  }

  void anExceptionOfOneCallComesBack() {
    setThreadCount(3);
    QVERIFY_EXCEPTION_THROWN(parallelFor(100,
                                         [](std::size_t i) {
                                           if (i == 50) {
                                             throw std::runtime_error("fifty");
                                           }
                                         }),
                             std::runtime_error);
    setThreadCount(0);
  }

  void orientationIsExact() {
    const Eigen::Vector2d a(0.5, 0.5);
    const Eigen::Vector2d b(12, 12);
    const double next = std::nextafter(24.0, 25.0);
    QCOMPARE(orient2d(a, b, {24, 24}), 0);
    QCOMPARE(orient2d(a, b, {24, next}), 1);
    QCOMPARE(orient2d(a, b, {next, 24}), -1);
    QCOMPARE(orient2d({0, 0}, {1e-200, 0}, {0, 1e-200}), 1);  // the products underflow
    QCOMPARE(orient2d({0, 0}, {0, 1e-200}, {1e-200, 0}), -1);
  }

  void aFileIsReplacedWhole() {
    const QTemporaryDir dir;
    const std::filesystem::path path = dir.filePath("a.txt").toStdString();
    QVERIFY(writeFile(path, "first"));
    QVERIFY(writeFile(path, "second"));
    QFile file(dir.filePath("a.txt"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QCOMPARE(file.readAll(), QByteArray("second"));
    QCOMPARE(QDir(dir.path()).entryList(QDir::Files), QStringList{"a.txt"});
  }

  void aLinkIsFollowedAndPermissionsAreKept() {
    const QTemporaryDir dir;
    const std::filesystem::path path = dir.filePath("a.txt").toStdString();
    const std::filesystem::path link = dir.filePath("link.txt").toStdString();
    QVERIFY(writeFile(path, "first"));
    std::filesystem::permissions(path,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    std::filesystem::create_symlink(path, link);
    QVERIFY(writeFile(link, "second"));
    QVERIFY(std::filesystem::is_symlink(link));
    QCOMPARE(std::filesystem::file_size(path), std::uintmax_t{6});
    QCOMPARE(std::filesystem::status(path).permissions(),
             std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  }

  void whatCannotBeWrittenSaysWhy() {
    const QTemporaryDir dir;
    const Result<void> missing = writeFile("/nowhere/at/all/a.txt", "x");
    QVERIFY(!missing);
    QCOMPARE(missing.error().code, ErrorCode::FileUnwritable);
    QVERIFY(missing.error().message.find("/nowhere/at/all/a.txt") == 0);
    QCOMPARE(writeFile(dir.path().toStdString(), "x").error().code, ErrorCode::FileUnwritable);
    QCOMPARE(writeFile("/dev/full", "x").error().code, ErrorCode::FileUnwritable);
    QVERIFY(writeFile("/dev/null", "x"));
  }
};

QTEST_APPLESS_MAIN(BaseTest)
#include "base_test.moc"
