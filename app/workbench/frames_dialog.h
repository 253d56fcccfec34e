#pragma once

#include <QDialog>
#include <QString>

#include "core/picture/film.h"

class QComboBox;
class QDialogButtonBox;
class QLineEdit;
class QSpinBox;

namespace graftsman {

struct CameraView;

/// The film with its cameras: seen from where a pane's camera looks, the whole result in view.
[[nodiscard]] Film withCameras(Film film, const FusionResults& results, const CameraView& view);

/// "Export frames": which film is written, and where to. Accepts once it may write over what is there.
class FramesDialog : public QDialog {
  Q_OBJECT

 public:
  explicit FramesDialog(QWidget* parent = nullptr);

  [[nodiscard]] QString folder() const;
  /// Without cameras.
  [[nodiscard]] Film film() const;

  void accept() override;

 private:
  void askFolder();
  void showWhole();

  QComboBox* kind_;
  QSpinBox* count_;
  QSpinBox* width_;
  QSpinBox* height_;
  QLineEdit* folder_;
  QDialogButtonBox* buttons_;
};

}  // namespace graftsman
