#include <QTemporaryDir>
#include <QtTest>
#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/project/project_file.h"
#include "tests/support/cli_runs.h"
#include "tests/support/projects.h"
#include "tests/support/samples.h"

using namespace graftsman;

class CliTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void helpShowsAnExample() {
    const Outcome outcome = runCli({"--help"});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(outcome.out.contains("graftsman-cli fuse nose.json -o nose.obj"));
    QCOMPARE(runCli({"fuse", "--help"}).exitCode, 0);
  }

  void anEmptyFileNameIsNamed() {
    const QString nose = scenario("fig8b_cone_nose");
    for (const QStringList& arguments :
         {QStringList{"check", ""}, QStringList{"fuse", "", "-o", "a.obj"},
          QStringList{"fuse", nose, "-o", ""}, QStringList{"fuse", nose, "-o", "a.obj", "--report", ""}}) {
      const Outcome outcome = runCli(arguments);
      verifyOneLineError(outcome);
      QVERIFY2(outcome.err.contains("file name is empty") || outcome.err.contains("file's name is empty"),
               outcome.err);
    }
  }

  void versionIsOneLine() {
    const Outcome outcome = runCli({"--version"});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(outcome.out.startsWith("graftsman-cli "));
  }

  void wrongUsageExitsWithTwo_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::newRow("nothing") << QStringList{};
    QTest::newRow("unknown command") << QStringList{"melt"};
    QTest::newRow("no output") << QStringList{"fuse", "a.json"};
    QTest::newRow("unknown option") << QStringList{"check", "a.obj", "--colour"};
    QTest::newRow("no threads") << QStringList{"fuse", "a.json", "-o", "b.obj", "--threads", "0"};
  }

  void wrongUsageExitsWithTwo() {
    QFETCH(QStringList, arguments);
    const Outcome outcome = runCli(arguments);
    QCOMPARE(outcome.exitCode, 2);
    QVERIFY(outcome.out.isEmpty());
    QCOMPARE(outcome.err.count('\n'), 1);
  }

  void everyScenarioIsWrittenAndReported_data() {
    QTest::addColumn<QString>("name");
    for (const std::string& name : samples::kScenarios) {
      QTest::newRow(name.c_str()) << QString::fromStdString(name);
    }
  }

  void everyScenarioIsWrittenAndReported() {
    QFETCH(QString, name);
    const QTemporaryDir dir;
    const QString mesh = dir.filePath("fused.obj");
    const QString report = dir.filePath("report.json");
    const Outcome outcome = runCli({"fuse", scenario(name.toStdString()), "-o", mesh, "--report", report});
    QCOMPARE(outcome.err, QByteArray());
    QCOMPARE(outcome.exitCode, 0);
    const auto json = nlohmann::json::parse(contentOf(report).toStdString());
    for (const char* key :
         {"read", "paths", "cut", "adjust", "embed", "overlay", "join", "blend", "write", "total"}) {
      QVERIFY2(json["milliseconds"][key].get<double>() >= 0, key);
    }
    for (const char* key : {"M1", "M2", "F1", "F2", "Fc", "Mc"}) {
      QVERIFY2(json["counts"][key]["v"].get<int>() > 0 && json["counts"][key]["f"].get<int>() > 0, key);
    }
    QVERIFY(json["checks"]["all_hold"].get<bool>());
    const Result<MeshFile> written = readMesh(mesh.toStdString(), {});
    QVERIFY(written);
    QCOMPARE(written->mesh->faceCount(), json["counts"]["Mc"]["f"].get<int>());
    QCOMPARE(written->mesh->vertexCount(), json["counts"]["Mc"]["v"].get<int>());
  }

  void verticesOffTheTileAreWrittenToTheLastBit() {
    const QTemporaryDir dir;
    const QString mesh = dir.filePath("fused.off");
    QCOMPARE(runCli({"fuse", scenario("fig9b_bird_plane"), "-o", mesh}).exitCode, 0);
    const auto base = samples::model("plane.ply");
    const Result<MeshFile> written = readMesh(mesh.toStdString(), {});
    QVERIFY(written);
    // Kept vertices come first, in the base's order: walk both lists together.
    Index kept = 0;
    for (Index v = 0; v < base->vertexCount() && kept < written->mesh->vertexCount(); ++v) {
      kept += base->point(v) == written->mesh->point(kept) ? 1 : 0;
    }
    QVERIFY(kept > base->vertexCount() - 900);
  }

  void theSameBytesWithOneAndTwoThreads() {
    const QTemporaryDir dir;
    QCOMPARE(runCli({"fuse", scenario("fig9b_bird_plane"), "-o", dir.filePath("1.ply"), "--threads", "1"})
                 .exitCode,
             0);
    QCOMPARE(runCli({"fuse", scenario("fig9b_bird_plane"), "-o", dir.filePath("2.ply"), "--threads", "2"})
                 .exitCode,
             0);
    QVERIFY(!contentOf(dir.filePath("1.ply")).isEmpty());
    QCOMPARE(contentOf(dir.filePath("1.ply")), contentOf(dir.filePath("2.ply")));
  }

  void everyFormatIsWritten_data() {
    QTest::addColumn<QString>("ending");
    for (const char* ending : {"obj", "ply", "stl", "off", "OBJ"}) {
      QTest::newRow(ending) << ending;
    }
  }

  void everyFormatIsWritten() {
    QFETCH(QString, ending);
    const QTemporaryDir dir;
    const QString mesh = dir.filePath("fused." + ending);
    QCOMPARE(runCli({"fuse", scenario("fig4a_cone_sphere"), "-o", mesh}).exitCode, 0);
    const Outcome outcome = runCli({"check", mesh, "--json"});
    QCOMPARE(outcome.exitCode, 0);
    const auto json = nlohmann::json::parse(outcome.out.toStdString());
    QVERIFY(json["mesh"]["closed"].get<bool>());
    QVERIFY(json["mesh"]["manifold"].get<bool>());
    QCOMPARE(json["mesh"]["euler_characteristic"].get<int>(), 2);
  }

  void glbIsWritten() {
    const QTemporaryDir dir;
    QCOMPARE(runCli({"fuse", scenario("fig4a_cone_sphere"), "-o", dir.filePath("a.glb")}).exitCode, 0);
    QVERIFY(contentOf(dir.filePath("a.glb")).startsWith("glTF"));
  }

  void theCurveOnTheCommandLineReplacesTheScenarios() {
    const QTemporaryDir dir;
    const auto fuseWith = [&](const QString& curve, const QString& name) {
      return runCli({"fuse", scenario("fig4b_cone_sphere"), "-o", dir.filePath(name), "--fcf", curve})
          .exitCode;
    };
    QCOMPARE(fuseWith("linear", "a.obj"), 0);
    QCOMPARE(runCli({"fuse", scenario("fig4d_cone_sphere"), "-o", dir.filePath("b.obj")}).exitCode, 0);
    QCOMPARE(fuseWith("half", "c.obj"), 0);
    QVERIFY(contentOf(dir.filePath("a.obj")) != contentOf(dir.filePath("b.obj")));
    QCOMPARE(contentOf(dir.filePath("c.obj")), contentOf(dir.filePath("b.obj")));
  }

  void theReportGoesToStdoutOnDemand() {
    const QTemporaryDir dir;
    const Outcome outcome =
        runCli({"fuse", scenario("fig4a_cone_sphere"), "-o", dir.filePath("a.obj"), "--report", "-"});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(nlohmann::json::parse(outcome.out.toStdString()).contains("seam"));
  }

  void aBadCurveIsOneLine_data() {
    QTest::addColumn<QString>("curve");
    QTest::newRow("equal s") << "0,0;0.5,0.2;0.5,0.4;1,1";
    QTest::newRow("falling s") << "0,0;0.6,0.2;0.5,0.4;1,1";
    QTest::newRow("three points") << "0,0;0.5,0.2;1,1";
    QTest::newRow("f above 1") << "0,0;0.3,1.2;0.5,0.4;1,1";
    QTest::newRow("ends early") << "0,0;0.3,0.2;0.5,0.4;0.9,1";
    QTest::newRow("no number") << "0,0;0.3,x;0.5,0.4;1,1";
    QTest::newRow("no preset") << "smooth";
    QTest::newRow("nothing") << "";
    QTest::newRow("nan") << "0,0;0.3,nan;0.5,0.4;1,1";
  }

  void aBadCurveIsOneLine() {
    QFETCH(QString, curve);
    const QTemporaryDir dir;
    verifyOneLineError(
        runCli({"fuse", scenario("fig4a_cone_sphere"), "-o", dir.filePath("a.obj"), "--fcf", curve}));
    QVERIFY(!QFile::exists(dir.filePath("a.obj")));
  }

  void anImpossibleLoopIsOneLineThatNamesTheFile_data() {
    QTest::addColumn<QString>("pairs");
    QTest::newRow("two pairs") << "[361, 241], [364, 246]";
    QTest::newRow("a repeated CV") << "[361, 241], [364, 246], [361, 251], [370, 256]";
    QTest::newRow("out of range") << "[361, 241], [364, 246], [99999, 251], [370, 256]";
    QTest::newRow("negative") << "[361, 241], [364, 246], [-1, 251], [370, 256]";
    QTest::newRow("clockwise") << "[382, 276], [376, 266], [370, 256], [364, 246]";
    QTest::newRow("half a pair") << "[361, 241], [364], [367, 251], [370, 256]";
    QTest::newRow("three of a pair") << "[361, 241], [364, 1, 2], [367, 251], [370, 256]";
  }

  void anImpossibleLoopIsOneLineThatNamesTheFile() {
    QFETCH(QString, pairs);
    const QTemporaryDir dir;
    const QString file = dir.filePath("loop.json");
    write(file, QString(R"({"name": "t", "m1": "%1", "m2": "%2", "cvp": [%3],
                            "fcf": [[0, 0], [0.3, 0.3], [0.6, 0.6], [1, 1]], "deform_exponent": 5})")
                    .arg(model("cone.stl"), model("sphere.off"), pairs)
                    .toUtf8());
    const Outcome outcome = runCli({"fuse", file, "-o", dir.filePath("a.obj")});
    verifyOneLineError(outcome);
    QVERIFY(outcome.err.contains("loop.json"));
  }

  void aMissingFileIsOneLine() {
    verifyOneLineError(runCli({"fuse", "/nowhere/a.json", "-o", "/tmp/never.obj"}));
    verifyOneLineError(runCli({"check", "/nowhere/a.obj"}));
    verifyOneLineError(runCli({"check", "/"}));
  }

  void anUnwritableOutputIsOneLineAndLeavesNothing() {
    verifyOneLineError(runCli({"fuse", scenario("fig4a_cone_sphere"), "-o", "/nowhere/a.obj"}));
    verifyOneLineError(runCli({"fuse", scenario("fig4a_cone_sphere"), "-o", "/tmp/a.xyz"}));
  }

  void whatIsReadIsNeverOverwritten() {
    const QTemporaryDir dir;
    const QString mesh = dir.filePath("sphere.off");
    QVERIFY(QFile::copy(model("sphere.off"), mesh));
    const QString file = dir.filePath("s.json");
    write(file, QString(R"({"m1": "%1", "m2": "sphere.off", "deform_exponent": 5, "fcf": "linear",
                            "cvp": [[361, 241], [367, 251], [373, 261], [379, 271]]})")
                    .arg(model("cone.stl"))
                    .toUtf8());
    QCOMPARE(runCli({"fuse", file, "-o", dir.filePath("a.obj")}).exitCode, 0);
    verifyOneLineError(runCli({"fuse", file, "-o", mesh}));
    verifyOneLineError(
        runCli({"fuse", file, "-o", dir.filePath("../" + QFileInfo(dir.path()).fileName() + "/sphere.off")}));
    verifyOneLineError(runCli({"fuse", file, "-o", dir.filePath("b.obj"), "--report", file}));
    verifyOneLineError(
        runCli({"fuse", file, "-o", dir.filePath("b.obj"), "--report", dir.filePath("b.obj")}));
    QCOMPARE(contentOf(mesh), contentOf(model("sphere.off")));
  }

  void checkDescribesAMeshOnStdout() {
    const Outcome outcome = runCli({"check", model("beetle.off")});
    QCOMPARE(outcome.exitCode, 0);
    QVERIFY(outcome.err.isEmpty());
    QVERIFY(outcome.out.contains("11"));
  }
};

QTEST_GUILESS_MAIN(CliTest)
#include "cli_test.moc"
