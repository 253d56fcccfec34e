#include "widgets/viewport/triangle_cells.h"

#include <vtkNew.h>
#include <vtkTypeInt32Array.h>

#include <cstring>

namespace graftsman {

vtkSmartPointer<vtkCellArray> triangleCells(std::span<const Face> faces) {
  const auto count = static_cast<vtkIdType>(faces.size());
  vtkNew<vtkTypeInt32Array> corners;
  corners->SetNumberOfValues(3 * count);
  if (count > 0) {
    std::memcpy(corners->GetPointer(0), faces.data(), faces.size_bytes());
  }
  vtkNew<vtkTypeInt32Array> offsets;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType f = 0; f <= count; ++f) {
    offsets->SetValue(f, static_cast<vtkTypeInt32>(3 * f));
  }
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(offsets, corners);
  return cells;
}

}  // namespace graftsman
