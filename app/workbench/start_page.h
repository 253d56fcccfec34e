#pragma once

#include <QWidget>

#include "core/base/error.h"

class QVBoxLayout;

namespace graftsman {

/// What is seen before a document is open: the samples as pictures, recent projects, how to begin, and three
/// steps.
class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  /// Lists the recent projects anew.
  void setRecent(const QStringList& paths);

 Q_SIGNALS:
  void openWanted(const QString& path);
  void loadWanted(graftsman::Side side);
  void openDialogWanted();

 private:
  [[nodiscard]] QWidget* makeSamples();
  [[nodiscard]] QWidget* makeSteps();

  QVBoxLayout* recent_ = nullptr;
};

}  // namespace graftsman
