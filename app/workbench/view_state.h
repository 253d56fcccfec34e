#pragma once

#include <string>

namespace graftsman {

class MainWindow;

/// How the window looks at the document (mode, cameras), as JSON text for the project file.
[[nodiscard]] std::string writeViewState(const MainWindow& window);

/// Takes it up again; what is missing or cannot be understood stays as it is. An empty text: Fusion mode if
/// there is something to fuse, Tiles mode if there is a mesh.
void readViewState(const std::string& state, MainWindow& window);

}  // namespace graftsman
