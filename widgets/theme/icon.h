#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace graftsman {

/// The line icon resources/icons/NAME.svg in the text colour of the application's palette, as it is when the
/// icon is drawn (disabled and selected: the palette's colours for these); sharp at any size and ratio. Null
/// if there is none of that name.
[[nodiscard]] QIcon icon(const QString& name);

/// The same in one colour ("problem" in the theme's colour for problems); disabled and selected as above.
[[nodiscard]] QIcon icon(const QString& name, const QColor& colour);

/// The program's own icon, in its colours.
[[nodiscard]] QIcon applicationIcon();

}  // namespace graftsman
