#pragma once

#include <QWidget>

namespace graftsman {

/// A line of text that is shortened with "…" where there is no room for it; then its tooltip is the whole.
class ElidedLabel : public QWidget {
  Q_OBJECT

 public:
  explicit ElidedLabel(QWidget* parent = nullptr);

  void setText(const QString& text);
  [[nodiscard]] const QString& text() const { return text_; }
  /// As painted.
  [[nodiscard]] QString shownText() const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QString text_;
};

}  // namespace graftsman
