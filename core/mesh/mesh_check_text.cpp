#include <array>
#include <charconv>
#include <cmath>
#include <string>

#include "core/mesh/mesh_check.h"

namespace graftsman {
namespace {

constexpr int kAngleDigits = 3;
constexpr int kLengthDigits = 9;

// With so many significant digits, whatever the locale.
std::string rounded(double value, int digits) {
  if (std::isinf(value)) {
    return value > 0 ? "beyond 1.8e308" : "beyond -1.8e308";
  }
  std::array<char, 64> text = {};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
  return std::string(text.data(), end.ptr);
}

std::string rounded(const Point& p) {
  return rounded(p.x(), kLengthDigits) + ", " + rounded(p.y(), kLengthDigits) + ", " +
         rounded(p.z(), kLengthDigits);
}

std::string inWords(Index vertex) {
  return std::to_string(vertex);
}

std::string inWords(const std::array<Index, 2>& edge) {
  return std::to_string(edge[0]) + "-" + std::to_string(edge[1]);
}

// "what: count: a b c …"; nothing if there are none.
template <class Defects>
std::string defects(const char* what, const Defects& listed, std::size_t count) {
  if (count == 0) {
    return "";
  }
  std::string line = std::string(what) + ": " + std::to_string(count) + ":";
  for (const auto& defect : listed) {
    line += ' ';
    line += inWords(defect);
  }
  return line + (count > listed.size() ? " ...\n" : "\n");
}

std::string number(const char* what, std::size_t count) {
  return count > 0 ? std::string(what) + ": " + std::to_string(count) + "\n" : "";
}

}  // namespace

std::string describe(const MeshCheck& c) {
  const auto yes = [](bool is) { return std::string(is ? "yes" : "no"); };
  return "vertices " + std::to_string(c.vertices) + ", edges " + std::to_string(c.edges) + ", faces " +
         std::to_string(c.faces) + "\n" +  //
         "components " + std::to_string(c.components) + ", border loops " + std::to_string(c.borderLoops) +
         " with " + std::to_string(c.borderEdges) + " edges, Euler characteristic " +
         std::to_string(c.eulerCharacteristic) + "\n" +  //
         "manifold: " + yes(c.manifold) + ", oriented: " + yes(c.oriented) +
         ", orientable: " + yes(c.orientable) + ", closed: " + yes(c.closed) + "\n" +
         defects("edges of three or more faces", c.edgesOfManyFaces, c.edgesOfManyFacesCount) +
         defects("edges whose two faces disagree", c.misorientedEdges, c.misorientedEdgesCount) +
         defects("singular vertices", c.singularVertices, c.singularVerticesCount) +
         number("isolated vertices", c.isolatedVertices) + number("faces without area", c.degenerateFaces) +
         "smallest angle " + rounded(c.smallestAngle, kAngleDigits) +
         " degrees, median of the faces' smallest angles " + rounded(c.medianSmallestAngle, kAngleDigits) +
         " degrees\n" +  //
         "area " + rounded(c.area, kLengthDigits) + ", volume " + rounded(c.volume, kLengthDigits) + "\n" +
         "box from (" + rounded(c.boxMin) + ") to (" + rounded(c.boxMax) + ")\n";
}

}  // namespace graftsman
