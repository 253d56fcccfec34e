#include <QDir>
#include <QTemporaryDir>
#include <map>

#include "core/io/csv.h"
#include "tests/support/cli_runs.h"
#include "tests/support/places.h"

using namespace graftsman;

namespace {

// Every file of the folder with its content, but for the shares' tables.
std::map<QString, QByteArray> contents(const QString& folder) {
  std::map<QString, QByteArray> result;
  for (const QString& name : QDir(folder).entryList(QDir::Files)) {
    if (!name.startsWith("table-")) {
      result[name] = contentOf(folder + "/" + name);
    }
  }
  return result;
}

// Six results of the small cone and sphere, with meshes and pictures.
QString smallSweep(const QTemporaryDir& dir) {
  const QString path = dir.filePath("sweep.json");
  write(path, "{\"fusion\": \"" + scenario("fig4a_cone_sphere").toUtf8() +
                  "\", \"fcf\": [\"paste\", \"half\"], \"deform_exponent\": [1, 2, 5], \"mesh\": \"off\", "
                  "\"picture\": {\"size\": [96, 72]}}");
  return path;
}

QSize sizeOfPng(const QByteArray& png) {
  const auto number = [&](int at) {
    return static_cast<int>(static_cast<unsigned char>(png[at])) << 8 |
           static_cast<unsigned char>(png[at + 1]);
  };
  return png.startsWith("\x89PNG") ? QSize(number(18), number(22)) : QSize();
}

}  // namespace

class SweepCliTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void theSampleNamesItsResultsBeforehand() {
    const QString sample = QString::fromStdString((places::samples() / "sweeps/nose.json").string());
    const Outcome outcome = runCli({"sweep", sample, "--dry-run"});
    QCOMPARE(outcome.exitCode, 0);
    QCOMPARE(outcome.err, QByteArray());
    QVERIFY(outcome.out.startsWith("24 results\n1\tcone_linear_fitted\n"));
    QCOMPARE(outcome.out.count('\n'), 25);
    const Outcome share = runCli({"sweep", sample, "--dry-run", "--only", "2/12"});
    QVERIFY(share.out.startsWith("2 results\n3\t"));
  }

  void aDryRunWritesNothing() {
    const QTemporaryDir dir;
    QCOMPARE(runCli({"sweep", smallSweep(dir), "-o", dir.filePath("out"), "--dry-run"}).exitCode, 0);
    QVERIFY(!QDir(dir.filePath("out")).exists());
  }

  void meshesPicturesAndTheTableAreWritten() {
    const QTemporaryDir dir;
    const QString out = dir.filePath("new/folder");
    const Outcome outcome = runCli({"sweep", smallSweep(dir), "-o", out});
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    const auto files = contents(out);
    QCOMPARE(files.size(), std::size_t{6 + 6 + 1});
    QVERIFY(files.count("paste_falloff-5.off") == 1);
    QCOMPARE(sizeOfPng(files.at("half_falloff-1.png")), QSize(96, 72));
    const std::string table = files.at("table.csv").toStdString();
    QCOMPARE(csv::parse(table, "table.csv").value().size(), std::size_t{7});
  }

  void sharesGiveTheSameBytesAsOneRunOnOneAndTwoThreads() {
    const QTemporaryDir dir;
    const QString sweep = smallSweep(dir);
    QCOMPARE(runCli({"sweep", sweep, "-o", dir.filePath("whole"), "--threads", "1"}).exitCode, 0);
    const auto expected = contents(dir.filePath("whole"));
    QCOMPARE(expected.size(), std::size_t{13});
    for (const QString& threads : {QString("1"), QString("2")}) {
      const QString out = dir.filePath("shares-" + threads);
      for (const char* share : {"4/4", "1/4", "3/4", "2/4"}) {
        const Outcome outcome = runCli({"sweep", sweep, "-o", out, "--only", share, "--threads", threads});
        QCOMPARE(outcome.err, QByteArray());
        QCOMPARE(outcome.exitCode, 0);
      }
      const Outcome merged = runCli({"sweep", "--merge", out});
      QCOMPARE(merged.err, QByteArray());
      QCOMPARE(merged.exitCode, 0);
      QVERIFY(contents(out) == expected);
    }
    QCOMPARE(runCli({"sweep", sweep, "-o", dir.filePath("two"), "--threads", "2"}).exitCode, 0);
    QVERIFY(contents(dir.filePath("two")) == expected);
  }

  void whatIsWrittenCanBeChosen() {
    const QTemporaryDir dir;
    const QString path = dir.filePath("s.json");
    write(path, "{\"fusion\": \"" + scenario("fig4a_cone_sphere").toUtf8() + "\"}");
    QCOMPARE(runCli({"sweep", path, "-o", dir.filePath("a")}).exitCode, 0);
    QCOMPARE(QDir(dir.filePath("a")).entryList(QDir::Files), (QStringList{"base.ply", "table.csv"}));
    QCOMPARE(runCli({"sweep", path, "-o", dir.filePath("b"), "--mesh", "none", "--picture"}).exitCode, 0);
    QCOMPARE(QDir(dir.filePath("b")).entryList(QDir::Files), (QStringList{"base.png", "table.csv"}));
  }

  void aMissingShareIsToldInOneLine() {
    const QTemporaryDir dir;
    const QString sweep = smallSweep(dir);
    verifyOneLineError(runCli({"sweep", "--merge", dir.filePath("none")}));
    QCOMPARE(runCli({"sweep", sweep, "-o", dir.filePath("out"), "--only", "1/2"}).exitCode, 0);
    const Outcome outcome = runCli({"sweep", "--merge", dir.filePath("out")});
    verifyOneLineError(outcome);
    QVERIFY(outcome.err.contains("share 2/2 is missing"));
  }

  void whatDoesNotFuseIsAWarning() {
    const QTemporaryDir dir;
    const QString path = dir.filePath("s.json");
    const QByteArray cone = QByteArray::fromStdString(samples::modelPath("cone.stl").string());
    const auto sweep = [&](const QByteArray& parts) {
      write(path,
            "{\"fusion\": \"" + scenario("fig4a_cone_sphere").toUtf8() + "\", \"parts\": [" + parts + "]}");
    };
    const QByteArray bad = "{\"name\": \"bad\", \"m1\": \"" + cone + "\", \"cvp\": [[0, 0], [1, 1]]}";
    sweep("{\"name\": \"good\"}, " + bad);
    const Outcome some = runCli({"sweep", path, "-o", dir.filePath("some")});
    QCOMPARE(some.exitCode, 0);
    QVERIFY(some.err.startsWith("graftsman-cli: warning: bad: "));
    QCOMPARE(some.err.count('\n'), 1);
    QVERIFY(QFile::exists(dir.filePath("some/good.ply")));
    sweep(bad);
    const Outcome none = runCli({"sweep", path, "-o", dir.filePath("none")});
    QCOMPARE(none.exitCode, 1);
    QCOMPARE(none.err.count('\n'), 2);
    QVERIFY(none.err.contains("none of the combinations fuses"));
    QVERIFY(QFile::exists(dir.filePath("none/table.csv")));
  }

  void errorsOfTheInputAreOneLine() {
    const QTemporaryDir dir;
    const QString path = dir.filePath("s.json");
    verifyOneLineError(runCli({"sweep", path, "-o", dir.filePath("out")}));
    write(path, R"({"fusion": "a.json", "fusions": 1})");
    const Outcome unknown = runCli({"sweep", path, "-o", dir.filePath("out")});
    verifyOneLineError(unknown);
    QVERIFY(unknown.err.contains("\"fusions\" is no key"));
    verifyOneLineError(runCli({"sweep", "", "-o", dir.filePath("out")}));
    verifyOneLineError(runCli({"sweep", smallSweep(dir), "-o", smallSweep(dir)}));
    verifyOneLineError(runCli({"frames", path, "-o", dir.filePath("out"), "--morph", "2"}));
  }

  void wrongUsageExitsWithTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("no sweep") << QStringList{"sweep"};
    QTest::newRow("no folder") << QStringList{"sweep", "a.json"};
    QTest::newRow("share 0") << QStringList{"sweep", "a.json", "-o", "b", "--only", "0/2"};
    QTest::newRow("share beyond") << QStringList{"sweep", "a.json", "-o", "b", "--only", "3/2"};
    QTest::newRow("no share") << QStringList{"sweep", "a.json", "-o", "b", "--only", "half"};
    QTest::newRow("merge and sweep") << QStringList{"sweep", "a.json", "--merge", "b"};
    QTest::newRow("unknown mesh") << QStringList{"sweep", "a.json", "-o", "b", "--mesh", "fbx"};
    QTest::newRow("no frames") << QStringList{"frames", "a.json", "-o", "b"};
    QTest::newRow("both") << QStringList{"frames", "a.json", "-o", "b", "--morph", "5", "--turntable", "5"};
    QTest::newRow("a morph of one") << QStringList{"frames", "a.json", "-o", "b", "--morph", "1"};
    QTest::newRow("no size") << QStringList{"frames",  "a.json", "-o",     "b",
                                            "--morph", "5",      "--size", "9000x1"};
  }
  void wrongUsageExitsWithTwo() {
    QFETCH(QStringList, arguments);
    const Outcome outcome = runCli(arguments);
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY(outcome.out.isEmpty());
    QCOMPARE(outcome.err.count('\n'), 1);
  }

  void framesOfATurntableGoRound() {
    const QTemporaryDir dir;
    const QString input = scenario("fig8b_cone_nose");
    const QString out = dir.filePath("frames");
    const Outcome outcome = runCli({"frames", input, "-o", out, "--turntable", "4", "--size", "80x60"});
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    const auto files = contents(out);
    QCOMPARE(files.size(), std::size_t{4});
    for (const auto& [name, bytes] : files) {
      QCOMPARE(sizeOfPng(bytes), QSize(80, 60));
    }
    QVERIFY(files.at("frame-001.png") != files.at("frame-003.png"));
  }

  void framesOfAMorphAreTheSameOnAnyNumberOfThreads() {
    const QTemporaryDir dir;
    const QString input = scenario("fig7_letters_bottle");
    for (const QString& threads : {QString("1"), QString("2")}) {
      QCOMPARE(runCli({"frames", input, "-o", dir.filePath(threads), "--morph", "5", "--size", "80x60",
                       "--threads", threads})
                   .exitCode,
               0);
    }
    const auto files = contents(dir.filePath("1"));
    QCOMPARE(files.size(), std::size_t{5});
    QVERIFY(files == contents(dir.filePath("2")));
    QVERIFY(files.at("frame-001.png") != files.at("frame-005.png"));
  }
};

QTEST_GUILESS_MAIN(SweepCliTest)
#include "sweep_cli_test.moc"
