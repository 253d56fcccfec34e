#include "core/io/assemble.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/io/triangulate.h"
#include "core/io/weld.h"

namespace graftsman {
namespace {

bool isDegenerate(const Face& f) {
  return f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
}

// Marks the vertices that faces use; false as soon as two faces share one.
bool markUnshared(const RawMesh& raw, std::vector<Index>& userOf) {
  Index user = 0;
  const auto mark = [&](Index v) {
    Index& known = userOf[static_cast<std::size_t>(v)];
    const bool isFirst = known < 0 || known == user;
    known = user;
    return isFirst;
  };
  for (const Face& face : raw.triangles) {
    if (!std::all_of(face.begin(), face.end(), mark)) {
      return false;
    }
    ++user;
  }
  for (std::size_t p = 0; p < raw.polygons.size(); ++p) {
    const auto corners = raw.corners(p);
    if (!std::all_of(corners.begin(), corners.end(), mark)) {
      return false;
    }
    ++user;
  }
  return true;
}

// Where no two faces share a vertex, merges equal ones. Vertices without a face are left alone. Returns the
// new vertex of each old one; empty if nothing was merged.
std::vector<Index> weldSoup(RawMesh& raw) {
  std::vector<Index> userOf(raw.faceCount() > 1 ? raw.points.size() : 0, -1);
  if (raw.faceCount() < 2 || !markUnshared(raw, userOf)) {
    return {};
  }
  PointWelder welder(raw.points.size() / 4);
  std::vector<Point> points;
  std::vector<Index> newOfWelded;
  std::vector<Index> newOf(raw.points.size());
  for (std::size_t v = 0; v < raw.points.size(); ++v) {
    std::size_t number = points.size();
    if (userOf[v] >= 0) {
      const auto welded = static_cast<std::size_t>(welder.add(raw.points[v]));
      if (welded == newOfWelded.size()) {
        newOfWelded.push_back(static_cast<Index>(number));
      }
      number = static_cast<std::size_t>(newOfWelded[welded]);
    }
    if (number == points.size()) {
      points.push_back(raw.points[v]);
    }
    newOf[v] = static_cast<Index>(number);
  }
  if (points.size() == raw.points.size()) {
    return {};
  }
  const auto renumber = [&](Index& v) { v = newOf[static_cast<std::size_t>(v)]; };
  for (Face& face : raw.triangles) {
    std::for_each(face.begin(), face.end(), renumber);
  }
  std::for_each(raw.polygonCorners.begin(), raw.polygonCorners.end(), renumber);
  raw.points = std::move(points);
  return newOf;
}

// The corners without those equal to the one before them.
void copyDistinct(std::span<const Index> corners, std::vector<Index>& distinct) {
  distinct.clear();
  for (const Index v : corners) {
    if (distinct.empty() || distinct.back() != v) {
      distinct.push_back(v);
    }
  }
  while (distinct.size() > 1 && distinct.front() == distinct.back()) {
    distinct.pop_back();
  }
}

// All faces in the file's order; polygons divided.
std::vector<Face> mergedFaces(const RawMesh& raw, ReadReport& report) {
  std::vector<Face> faces;
  faces.reserve(raw.triangles.size() + raw.polygonCorners.size());
  std::vector<Index> distinct;
  auto nextTriangle = raw.triangles.begin();
  for (std::size_t p = 0; p < raw.polygons.size(); ++p) {
    const auto before = raw.triangles.begin() + raw.polygons[p].trianglesBefore;
    faces.insert(faces.end(), nextTriangle, before);
    nextTriangle = before;
    const std::span<const Index> corners = raw.corners(p);
    copyDistinct(corners, distinct);
    const std::size_t facesBefore = faces.size();
    triangulate(distinct, raw.points, faces);
    report.triangulated += faces.size() > facesBefore + 1 ? 1 : 0;
    const std::size_t wanted = std::max<std::size_t>(corners.size(), 3) - 2;
    report.droppedDegenerate += wanted - std::min(wanted, faces.size() - facesBefore);
  }
  faces.insert(faces.end(), nextTriangle, raw.triangles.end());
  return faces;
}

// Removes the faces that say the same as an earlier one. They share all edges in the same direction, so none
// of their edges is regular: only such faces need a look.
std::size_t dropDuplicates(const TriangleMesh& mesh, std::vector<Face>& faces) {
  std::vector<std::pair<Face, Index>> suspects;
  for (Index f = 0; f < mesh.faceCount(); ++f) {
    if (mesh.twin(3 * f) < 0 && mesh.twin(3 * f + 1) < 0 && mesh.twin(3 * f + 2) < 0 &&
        mesh.singular(mesh.face(f)[0])) {
      Face face = mesh.face(f);
      std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
      suspects.emplace_back(face, f);
    }
  }
  std::sort(suspects.begin(), suspects.end());
  std::vector<bool> isDuplicate(suspects.empty() ? 0 : mesh.faces().size(), false);
  std::size_t count = 0;
  for (std::size_t i = 1; i < suspects.size(); ++i) {
    if (suspects[i].first == suspects[i - 1].first) {
      isDuplicate[static_cast<std::size_t>(suspects[i].second)] = true;
      ++count;
    }
  }
  if (count > 0) {
    faces = mesh.faces();
    std::size_t kept = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!isDuplicate[f]) {
        faces[kept++] = faces[f];
      }
    }
    faces.resize(kept);
  }
  return count;
}

}  // namespace

TriangleSoup triangulated(RawMesh raw) {
  TriangleSoup soup;
  soup.report.binary = raw.binary;
  soup.report.fileVertices = raw.fileVertices > 0 ? raw.fileVertices : raw.points.size();
  soup.report.fileFaces = raw.faceCount();
  if (raw.fileVertices == 0) {
    soup.vertexOfFileVertex = weldSoup(raw);
  }
  soup.report.welded = soup.report.fileVertices - raw.points.size();
  soup.faces = raw.polygons.empty() ? std::move(raw.triangles) : mergedFaces(raw, soup.report);
  soup.report.droppedDegenerate += std::erase_if(soup.faces, isDegenerate);
  soup.points = std::move(raw.points);
  return soup;
}

Result<MeshFile> assembled(TriangleSoup soup, const std::string& name) {
  constexpr auto kMostFaces = static_cast<std::size_t>(std::numeric_limits<Index>::max() / 3);
  if (soup.faces.size() > kMostFaces) {
    return fail(ErrorCode::FileMalformed, name + ": the mesh has " + std::to_string(soup.faces.size()) +
                                              " triangles, more than " + std::to_string(kMostFaces));
  }
  if (soup.faces.empty()) {
    return fail(ErrorCode::MeshEmpty, name + ": the file has " + std::to_string(soup.report.fileVertices) +
                                          " vertices, but no face" +
                                          (soup.report.fileFaces > 0 ? " with three different corners" : ""));
  }
  auto mesh = std::make_shared<const TriangleMesh>(std::move(soup.points), std::move(soup.faces));
  MeshFile file;
  file.report = soup.report;
  std::vector<Face> kept;
  file.report.droppedDuplicate = dropDuplicates(*mesh, kept);
  if (file.report.droppedDuplicate > 0) {
    mesh = std::make_shared<const TriangleMesh>(mesh->points(), std::move(kept));
  }
  for (Index v = 0; v < mesh->vertexCount(); ++v) {
    file.report.isolated += mesh->outgoing(v) < 0 ? 1 : 0;
  }
  file.mesh = std::move(mesh);
  file.vertexOfFileVertex = std::move(soup.vertexOfFileVertex);
  return file;
}

}  // namespace graftsman
