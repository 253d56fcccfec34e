#pragma once

class QRect;
class QWidget;

namespace graftsman {

/// Draws a frame round a place of the widget that fades away within a second, once: something changed here,
/// and not by the hand.
void flash(QWidget& widget, const QRect& place);

}  // namespace graftsman
