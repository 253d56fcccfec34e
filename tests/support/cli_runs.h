#pragma once

#include <QProcess>
#include <QtTest>

#include "core/base/error.h"
#include "core/project/project_file.h"
#include "tests/support/places.h"
#include "tests/support/projects.h"
#include "tests/support/samples.h"

namespace graftsman {

struct Outcome {
  int exitCode = -1;
  QByteArray out;
  QByteArray err;
};

inline Outcome runCli(const QStringList& arguments) {
  QProcess process;
  process.start(QString::fromStdString(places::commandLine().string()), arguments);
  constexpr int kMostMilliseconds = 300000;
  if (!process.waitForFinished(kMostMilliseconds) || process.exitStatus() != QProcess::NormalExit) {
    return {};
  }
  return {process.exitCode(), process.readAllStandardOutput(), process.readAllStandardError()};
}

inline QString scenario(const std::string& name) {
  return QString::fromStdString(samples::scenarioPath(name).string());
}

inline QString model(const std::string& name) {
  return QString::fromStdString(samples::modelPath(name).string());
}

inline QByteArray contentOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline void write(const QString& path, const QByteArray& content) {
  QFile file(path);
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(content);
}

// Exit code 1, nothing on stdout, exactly one line on stderr.
inline void verifyOneLineError(const Outcome& outcome) {
  QCOMPARE(outcome.exitCode, 1);
  QVERIFY(outcome.out.isEmpty());
  QVERIFY(outcome.err.startsWith("graftsman-cli: error: "));
  QCOMPARE(outcome.err.count('\n'), 1);
}

}  // namespace graftsman
