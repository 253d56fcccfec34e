#pragma once

#include <vtkOpenGLPolyDataMapper.h>

#include <Eigen/Geometry>

namespace graftsman {

/// A mapper that is told the bounds of what it draws: looking for them costs more than the drawing's other
/// steps together. For the .cpp files that know VTK.
class MorphMapper : public vtkOpenGLPolyDataMapper {
 public:
  vtkTypeMacro(MorphMapper, vtkOpenGLPolyDataMapper) static MorphMapper* New();

  void setBox(const Eigen::AlignedBox3d& box);
  void ComputeBounds() override;

 protected:
  MorphMapper();

 private:
  Eigen::AlignedBox3d box_;
};

}  // namespace graftsman
