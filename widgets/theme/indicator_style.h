#pragma once

#include <QProxyStyle>

namespace graftsman {

/// Qt's Fusion style with frames of check boxes and radio buttons that are seen in a dark palette, too: there
/// Fusion draws them darker than the window. In a light palette nothing changes.
class IndicatorStyle : public QProxyStyle {
 public:
  IndicatorStyle();

  /// Gives the program this style where it would have Fusion; a style that the person chose stays.
  static void install();

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget = nullptr) const override;
};

}  // namespace graftsman
