#pragma once

#include <QCheckBox>
#include <QListWidget>
#include <QPushButton>

#include "app/document/document_commands.h"
#include "app/workbench/sweep_dialog.h"
#include "core/sweep/sweep_folder.h"
#include "core/sweep/sweep_run.h"
#include "tests/support/gallery.h"
#include "tests/support/stacked.h"

namespace graftsman {

/// The dialog under a test's hands.
struct SweepHands {
  const Workbench& bench;

  void open() const {
    bench.activate();
    QTest::keyClick(bench.window.get(), Qt::Key_W, Qt::ControlModifier | Qt::ShiftModifier);
    if (!QTest::qWaitForWindowExposed(dialog())) {
      qFatal("no dialog");
    }
  }
  [[nodiscard]] SweepDialog* dialog() const { return bench.window->findChild<SweepDialog*>("sweepDialog"); }
  template <class T>
  [[nodiscard]] T* the(const char* name) const {
    return dialog()->findChild<T*>(name);
  }
  [[nodiscard]] QString count() const { return the<QLabel>("sweepCount")->text(); }
  [[nodiscard]] QString summary() const { return the<QLabel>("sweepSummary")->text(); }
  [[nodiscard]] QString problem() const {
    QStringList texts;
    for (const QLabel* label : dialog()->findChild<QWidget*>("sweepProblem")->findChildren<QLabel*>()) {
      texts.append(label->text());
    }
    return texts.join(' ');
  }

  /// Clicks on the box of each of these entries, which begin so.
  void click(const char* list, const QStringList& entries) const {
    auto* view = the<QListWidget>(list);
    for (const QString& entry : entries) {
      const auto found = view->findItems(entry, Qt::MatchStartsWith);
      if (found.size() != 1) {
        qFatal("%s has %d of %s", list, static_cast<int>(found.size()), qPrintable(entry));
      }
      view->scrollToItem(found.front());
      const Qt::CheckState before = found.front()->checkState();
      const QRect rect = view->visualItemRect(found.front());
      QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, QPoint(rect.left() + 9, rect.center().y()));
      if (found.front()->checkState() == before) {
        qFatal("%s is not hit", qPrintable(entry));
      }
    }
  }
  void type(const char* line, const QString& text) const {
    auto* edit = the<QLineEdit>(line);
    QTest::mouseClick(edit, Qt::LeftButton);
    edit->clear();
    QTest::keyClicks(edit, text);
  }
  void press(const char* button) const { QTest::mouseClick(the<QPushButton>(button), Qt::LeftButton); }
  [[nodiscard]] bool done() const {
    return QTest::qWaitFor([this] { return !dialog()->busy(); }, kPatienceMs);
  }
  /// Files to be written there, meshes as PLY, without pictures.
  void writeTo(const QString& folder) const {
    auto* files = the<QCheckBox>("sweepFiles");
    if (!files->isChecked()) {
      QTest::mouseClick(files, Qt::LeftButton, {}, QPoint(8, files->height() / 2));
      auto* pictures = the<QCheckBox>("sweepPictures");
      QTest::mouseClick(pictures, Qt::LeftButton, {}, QPoint(8, pictures->height() / 2));
    }
    type("sweepFolder", folder);
  }
};

inline QStringList names(const VariantList& variants) {
  QStringList names;
  for (const auto& variant : variants) {
    names.append(QString::fromStdString(variant->name));
  }
  return names;
}

inline QByteArray bytesOf(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable " + path.toUtf8());
}

}  // namespace graftsman
