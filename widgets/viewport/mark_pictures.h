#pragma once

#include <QColor>
#include <QFont>
#include <QHash>
#include <QImage>
#include <QString>

#include "widgets/theme/theme.h"

namespace graftsman {

/// How a CV looks.
struct MarkLook {
  int number = 0;
  bool hollow = false;
  bool selected = false;
  bool problem = false;
  bool hovered = false;
  friend bool operator==(const MarkLook&, const MarkLook&) = default;
};

/// The pictures that a pane paints over its scene, with smooth edges, drawn once and kept: a QOpenGLWidget
/// paints images quickly, and shapes without antialiasing. Each picture's middle is the place it marks.
class MarkPictures {
 public:
  /// Forgets the pictures of another theme, font or ratio of pixels.
  void prepare(const Theme& theme, const QFont& font, double ratio);

  [[nodiscard]] QImage sphere(const MarkLook& look);
  /// The number, with a sign if there is a problem, on a ground that any scene leaves readable.
  [[nodiscard]] QImage label(const MarkLook& look);
  /// The sign of a path with a problem.
  [[nodiscard]] QImage problemSign();
  /// The vertex that a click would take; `ringed` where the keyboard has led.
  [[nodiscard]] QImage dot(bool ringed);
  /// A ring of this radius, in device-independent pixels. Not kept.
  [[nodiscard]] QImage ring(double radius, double opacity) const;

 private:
  template <class Draw>
  QImage kept(const QString& key, const QSizeF& size, Draw draw);
  [[nodiscard]] QImage pill(const QString& key, const QString& text, bool problem);

  Theme theme_;
  QFont font_;
  double ratio_ = 0;
  QHash<QString, QImage> pictures_;
};

}  // namespace graftsman
