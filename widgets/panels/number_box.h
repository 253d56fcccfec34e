#pragma once

#include <QDoubleSpinBox>
#include <QSpinBox>
#include <QWheelEvent>

namespace graftsman {

/// A spin box for a document's number: valueChanged() comes once for each change, when it is complete (Enter,
/// focus out, a step), and the wheel changes nothing that a person has not chosen before: it scrolls the
/// panel.
template <class Box>
class NumberBox : public Box {
 public:
  explicit NumberBox(QWidget* parent = nullptr) : Box(parent) {
    this->setKeyboardTracking(false);
    this->setFocusPolicy(Qt::StrongFocus);
    this->setAlignment(Qt::AlignRight);
  }

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (this->hasFocus()) {
      Box::wheelEvent(event);
    } else {
      event->ignore();
    }
  }
};

using RealBox = NumberBox<QDoubleSpinBox>;
using WholeBox = NumberBox<QSpinBox>;

}  // namespace graftsman
