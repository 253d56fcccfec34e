#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <QTemporaryDir>
#include <QtTest>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "core/io/mesh_writer.h"
#include "core/io/read_file.h"
#include "tests/support/mesh_file_texts.h"
#include "tests/support/mesh_text.h"
#include "tests/support/places.h"
#include "tests/support/shapes.h"

using namespace graftsman;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

class MemoryLimit {
 public:
  explicit MemoryLimit(std::size_t more) {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    ::getrlimit(RLIMIT_AS, &old_);
    const rlimit limit = {pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + more, old_.rlim_max};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &old_); }

 private:
  rlimit old_ = {};
};

}  // namespace

class MeshFileErrorsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatCannotBeWrittenIsRefused() {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const MeshFormat format : kFormats) {
      const std::vector<Point> points = {{0, 0, 0}, {1, infinity, 0}};
      const auto text = formatMesh(format, "x.y", points, {}, {}, {});
      QCOMPARE(text.error().code, ErrorCode::FileUnwritable);
      QCOMPARE(text.error().message,
               "x.y: cannot be written: vertex 1 has a coordinate that is not a finite number");
    }
    const std::vector<Point> large = {{0, -1e39, 0}};
    QCOMPARE(formatMesh(MeshFormat::Stl, "x", large, {}, {true}, {}).error().message,
             "x: cannot be written: vertex 0 has a coordinate that is too large for binary STL; choose "
             "another format");
    QVERIFY(formatMesh(MeshFormat::Stl, "x", large, {}, {false}, {}).has_value());
  }

  void filesAreWrittenAndReadBack() {
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const auto torus = shapes::torus(20, 10);
    for (const char* const name : {"a.obj", "a.ply", "a.off", "a b.OFF"}) {
      QVERIFY(writeMesh(root / name, torus->points(), torus->faces(), {}, {}).has_value());
      const auto file = readMesh(root / name, {}).value();
      QVERIFY(sameBits(file.mesh->points(), torus->points()));
      QCOMPARE(file.mesh->faces(), torus->faces());
    }
    QCOMPARE(writeMesh(root / "none" / "a.obj", torus->points(), torus->faces(), {}, {}).error().code,
             ErrorCode::FileUnwritable);
    QCOMPARE(writeMesh(root, torus->points(), torus->faces(), {}, {}).error().code, ErrorCode::FormatUnknown);
  }

  void whatCannotBeReadIsSaid() {
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    fs::create_directory(root / "folder.obj");
    fs::create_symlink("/dev/zero", root / "zero.stl");
    std::ofstream(root / "empty.ply").flush();
    const auto message = [&](const char* name, ErrorCode code) {
      const auto file = readMesh(root / name, {});
      return !file && file.error().code == code ? file.error().message.substr(root.string().size() + 1) : "";
    };
    QCOMPARE(message("none.obj", ErrorCode::FileUnreadable),
             "none.obj: cannot be read: No such file or directory");
    QCOMPARE(message("folder.obj", ErrorCode::FileUnreadable), "folder.obj: cannot be read: it is a folder");
    QCOMPARE(message("zero.stl", ErrorCode::FileUnreadable),
             "zero.stl: cannot be read: it is a device or a socket, not a file");
    QCOMPARE(message("no\nne\x1b.obj", ErrorCode::FileUnreadable),
             "no\\x0ane\\x1b.obj: cannot be read: No such file or directory");
    QCOMPARE(readMesh(root / "empty.ply", {}).error().message, "empty.ply: the file is empty");
    QCOMPARE(readMesh(root / "empty.ply", {}).error().code, ErrorCode::FileMalformed);
    std::ofstream(root / "b\ta\xc2\x9b\xc3\xa9.obj") << "v 0 x 0";
    QCOMPARE(readMesh(root / "b\ta\xc2\x9b\xc3\xa9.obj", {}).error().message,
             "b\\x09a\\xc2\\x9b\xc3\xa9.obj:1: expected the y coordinate of vertex 1, found 'x'");
  }

  void aPipeIsReadToItsEnd() {
    const QTemporaryDir folder;
    const fs::path path = fs::path(folder.path().toStdString()) / "pipe.obj";
    QCOMPARE(::mkfifo(path.c_str(), 0600), 0);
    std::string text;
    while (text.size() < 300000) {
      text += "# more than a pipe holds at once\n";
    }
    text += kTriangle;
    const std::jthread writer([&] { std::ofstream(path) << text; });
    QCOMPARE(readMesh(path, {}).value().mesh->faceCount(), 1);
  }

  void aPipeThatNobodyWritesToCanBeGivenUp() {
    const QTemporaryDir folder;
    const fs::path path = fs::path(folder.path().toStdString()) / "pipe.obj";
    QCOMPARE(::mkfifo(path.c_str(), 0600), 0);
    int calls = 0;
    const Progress progress([&](double) { return ++calls < 3; }, 0ns);
    QCOMPARE(readMesh(path, progress).error().code, ErrorCode::Cancelled);
  }

  void everyStepCanBeCancelled() {
    const QTemporaryDir folder;
    const fs::path root = folder.path().toStdString();
    const auto sphere = shapes::icosphere(4);
    for (const char* const name : {"a.obj", "a.ply", "a.stl", "a.off"}) {
      for (const bool write : {true, false}) {
        const auto codeOf = [&](const Progress& progress) {
          ErrorCode code = ErrorCode::Unexpected;
          if (write) {
            const auto done = writeMesh(root / name, sphere->points(), sphere->faces(), {false}, progress);
            code = done ? code : done.error().code;
          } else {
            const auto done = readMesh(root / name, progress);
            code = done ? code : done.error().code;
          }
          return code;
        };
        int calls = 0;
        double last = 0;
        QCOMPARE(codeOf(Progress([&](double d) { return ++calls, last = d, true; }, 0ns)),
                 ErrorCode::Unexpected);
        QVERIFY(calls > 2 && last <= 1);
        for (int stop = 1; stop <= calls; ++stop) {
          int seen = 0;
          QCOMPARE(codeOf(Progress([&](double) { return ++seen < stop; }, 0ns)), ErrorCode::Cancelled);
        }
      }
    }
  }

  void memoryThatIsNotThereIsAnError() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    QSKIP("the sanitizer's own memory does not fit a limit");
#endif
    const QTemporaryDir folder;
    const fs::path path = fs::path(folder.path().toStdString()) / "a.obj";
    std::ofstream(path).flush();
    fs::resize_file(path, std::uintmax_t{1} << 30);  // nothing is stored of it
    std::string text;
    while (text.size() < 50000000) {
      text += "v 0 0 0\n";
    }
    std::optional<Result<MeshFile>> read;
    std::optional<Result<MeshFile>> parsed;
    {
      const MemoryLimit limit(std::size_t{20} << 20);
      read.emplace(readMesh(path, {}));
      parsed.emplace(parseMesh(text, MeshFormat::Obj, "a.obj", {}));
    }
    QCOMPARE(read->error().code, ErrorCode::OutOfMemory);
    QVERIFY(read->error().message.ends_with("not enough memory to read the file (1073741824 bytes)"));
    QCOMPARE(parsed->error().code, ErrorCode::OutOfMemory);
    QCOMPARE(parsed->error().message, "a.obj: not enough memory for the mesh in a file of 50000000 bytes");
  }

  void aByteOrderMarkBeforeTextIsSkipped() {
    const std::string text = "\xEF\xBB\xBFv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    const auto file = parseMesh(text, MeshFormat::Obj, "a.obj", {});
    QVERIFY(file.has_value());
    QCOMPARE(file->mesh->vertexCount(), 3);
    QCOMPARE(file->mesh->point(1), Point(1, 0, 0));
  }

  void whatFuzzingFoundStaysMended() {
    const fs::path root = places::testData() / "fuzz";
    int files = 0;
    for (const MeshFormat format : kFormats) {
      static constexpr std::array kFolders = {"obj", "ply", "stl", "off"};
      for (const auto& entry : fs::directory_iterator(root / kFolders[static_cast<std::size_t>(format)])) {
        const auto bytes = readFile(entry.path(), {}).value();
        const auto file = parseMesh(bytes.bytes(), format, "fuzzed", {});
        const bool isBad = entry.path().filename().string().starts_with("bad");
        QVERIFY2(file.has_value() == !isBad, entry.path().c_str());
        ++files;
      }
    }
    QVERIFY(files >= 14);
  }
};

QTEST_APPLESS_MAIN(MeshFileErrorsTest)
#include "mesh_file_errors_test.moc"
