#pragma once

#include <vtkCellArray.h>
#include <vtkSmartPointer.h>

#include <span>

#include "core/mesh/triangle_mesh.h"

namespace graftsman {

/// Triangles as VTK has them. Copies. For the .cpp files that know VTK.
[[nodiscard]] vtkSmartPointer<vtkCellArray> triangleCells(std::span<const Face> faces);

}  // namespace graftsman
