// Kills a program that saves a project, again and again: this very program, started with an argument.

#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <ctime>
#include <random>

#include "core/project/project_file.h"
#include "tests/support/projects.h"

using namespace graftsman;
using namespace graftsman::projects;
namespace fs = std::filesystem;

namespace {

// What the killed program saves by turns: two documents of unlike meshes, large enough that a kill mostly
// falls into the writing of them.
std::vector<Project> savedByTurns() {
  Project one = fullProject();
  fusionOf(one).base = asset("one", shapes::icosphere(5));
  Project other = fullProject();
  fusionOf(other).base = asset("other", shapes::torus(100, 90));
  fusionOf(other).inputs.fcf = FCF::preset(FCF::Preset::Paste);
  return {one, other};
}

// The program that gets killed: saves until the kernel's timer, which starts with the first save done, sends
// it SIGKILL.
int saveUntilKilled(const fs::path& path, long microseconds) {
  const std::vector<Project> projects = savedByTurns();
  for (std::size_t turn = 0;; ++turn) {
    if (!writeProject(path, projects[turn % 2], {})) {
      return 1;
    }
    if (turn == 1) {
      sigevent event = {};
      event.sigev_notify = SIGEV_SIGNAL;
      event.sigev_signo = SIGKILL;
      timer_t timer = {};
      const itimerspec time = {{}, {0, microseconds * 1000}};
      if (timer_create(CLOCK_MONOTONIC, &event, &timer) != 0 ||
          timer_settime(timer, 0, &time, nullptr) != 0) {
        return 2;
      }
    }
  }
}

}  // namespace

class ProjectKillTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void aProjectThatIsKilledWhileItSavesIsTheOldOrTheNewOne() {
    constexpr int kKills = 120;
    constexpr long kLatest = 40000;  // microseconds; a save takes a few thousand
    std::mt19937 random(7);
    const QTemporaryDir reference;
    const fs::path path = fs::path(reference.path().toStdString()) / "whole.graft";
    std::vector<std::string> whole;
    for (const Project& project : savedByTurns()) {
      mustSucceed(writeProject(path, project, {}));
      whole.push_back(readAll(path));
    }
    std::array<int, 2> found = {};
    int amidst = 0;
    for (int kill = 0; kill < kKills; ++kill) {
      const long moment = std::uniform_int_distribution<long>(1, kLatest)(random);
      const QTemporaryDir folder;
      const fs::path file = fs::path(folder.path().toStdString()) / "killed.graft";
      QProcess process;
      process.start(QCoreApplication::applicationFilePath(),
                    {"--save-until-killed", QString::fromStdString(file.string()), QString::number(moment)});
      QVERIFY(process.waitForFinished());
      QVERIFY2(process.exitStatus() == QProcess::CrashExit, "the program ended by itself");
      const std::string bytes = readAll(file);
      const auto match = std::find(whole.begin(), whole.end(), bytes);
      QVERIFY2(match != whole.end(), "the file is neither of the two");
      ++found[static_cast<std::size_t>(match - whole.begin())];
      const Result<LoadedProject> loaded = readProject(file, {});
      QVERIFY(loaded && loaded->damage.empty());
      amidst += QDir(folder.path()).entryList({"*.part"}).empty() ? 0 : 1;
    }
    qInfo(
        "killed %d times, of these %d with a half-written file beside: the project was whole each time, %d "
        "times the one and %d times the other",
        kKills, amidst, found[0], found[1]);
    QVERIFY(amidst > 0 && found[0] > 0 && found[1] > 0);
  }
};

int main(int argc, char** argv) {
  if (argc == 4 && std::strcmp(argv[1], "--save-until-killed") == 0) {
    return saveUntilKilled(argv[2], std::stol(argv[3]));
  }
  QCoreApplication app(argc, argv);
  ProjectKillTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "project_kill_test.moc"
