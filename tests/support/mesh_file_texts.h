#pragma once

#include <QtTest>
#include <cstring>

#include "core/io/mesh_writer.h"
#include "core/io/read_file.h"
#include "tests/support/mesh_text.h"
#include "tests/support/shapes.h"

namespace graftsman {

using namespace std::chrono_literals;

inline const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
inline constexpr std::array kFormats = {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Stl, MeshFormat::Off};

inline bool sameBits(const std::vector<Point>& a, const std::vector<Point>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Point)) == 0;
}

}  // namespace graftsman
