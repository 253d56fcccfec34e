#include "core/io/glb_writer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cassert>
#include <cstdint>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/base/write_file.h"
#include "core/io/printable.h"

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

namespace graftsman {
namespace {

using Json = nlohmann::ordered_json;
using FloatVectors = std::vector<Eigen::Vector3f>;

// Sizes of a model whose coordinates, differences and normals stay in the range of floats with room to spare.
constexpr double kSmallestSize = 1e-30;
constexpr double kGreatestSize = 1e30;

// Of glTF 2.0.
constexpr int kFloat = 5126;
constexpr int kUnsignedInt = 5125;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;
constexpr int kTriangles = 4;
constexpr int kNoTarget = 0;  // of a view that no vertex or face is drawn from

// Unit normals, each the mean of its faces' weighted by area; (0, 0, 1) where none is defined, since glTF
// demands unit length.
std::vector<Eigen::Vector3d> normals(std::span<const Point> points, std::span<const Face> faces,
                                     double size) {
  std::vector<Eigen::Vector3d> sums(points.size(), Eigen::Vector3d::Zero());
  const auto at = [&](Index v) -> const Point& { return points[static_cast<std::size_t>(v)]; };
  for (const auto& [a, b, c] : faces) {
    const Eigen::Vector3d area = ((at(b) - at(a)) / size).cross((at(c) - at(a)) / size);
    for (const Index v : {a, b, c}) {
      sums[static_cast<std::size_t>(v)] += area;
    }
  }
  for (Eigen::Vector3d& sum : sums) {
    const double length = sum.norm();
    sum = length > 0 ? Eigen::Vector3d(sum / length) : Eigen::Vector3d::UnitZ();
  }
  return sums;
}

/// The binary chunk and its description, grown together.
class Buffer {
 public:
  /// Adds V×3 floats and returns the accessor's number.
  int add(const FloatVectors& vectors, bool withRange) {
    Json accessor = {{"bufferView", view(vectors.data(), vectors.size() * sizeof(vectors[0]), kArrayBuffer)},
                     {"componentType", kFloat},
                     {"count", vectors.size()},
                     {"type", "VEC3"}};
    if (withRange) {
      Eigen::Vector3f low = vectors[0];
      Eigen::Vector3f high = vectors[0];
      for (const Eigen::Vector3f& vector : vectors) {
        low = low.cwiseMin(vector);
        high = high.cwiseMax(vector);
      }
      accessor["min"] = {low.x(), low.y(), low.z()};
      accessor["max"] = {high.x(), high.y(), high.z()};
    }
    return addAccessor(std::move(accessor));
  }

  int add(std::span<const Face> faces) {
    static_assert(sizeof(Face) == 3 * sizeof(std::uint32_t));
    return addAccessor({{"bufferView", view(faces.data(), faces.size_bytes(), kElementArrayBuffer)},
                        {"componentType", kUnsignedInt},
                        {"count", 3 * faces.size()},
                        {"type", "SCALAR"}});
  }

  /// Times or weights of an animation.
  int add(const std::vector<float>& numbers) {
    Json accessor = {{"bufferView", view(numbers.data(), numbers.size() * sizeof(float), kNoTarget)},
                     {"componentType", kFloat},
                     {"count", numbers.size()},
                     {"type", "SCALAR"}};
    const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
    accessor["min"] = Json::array({*low});
    accessor["max"] = Json::array({*high});
    return addAccessor(std::move(accessor));
  }

  void describe(Json& gltf) const {
    gltf["accessors"] = accessors_;
    gltf["bufferViews"] = views_;
    gltf["buffers"] = {{{"byteLength", bytes_.size()}}};
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  void reserve(std::size_t size) { bytes_.reserve(size); }

 private:
  // Everything has a size of a multiple of four bytes, as its alignment demands.
  int view(const void* data, std::size_t size, int target) {
    views_.push_back({{"buffer", 0}, {"byteOffset", bytes_.size()}, {"byteLength", size}});
    if (target != kNoTarget) {
      views_.back()["target"] = target;
    }
    bytes_.append(static_cast<const char*>(data), size);
    return static_cast<int>(views_.size()) - 1;
  }

  int addAccessor(Json accessor) {
    accessors_.push_back(std::move(accessor));
    return static_cast<int>(accessors_.size()) - 1;
  }

  std::string bytes_;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
};

FloatVectors toFloats(std::size_t count, const auto& vectorAt) {
  FloatVectors result(count);
  for (std::size_t i = 0; i < count; ++i) {
    result[i] = vectorAt(i).template cast<float>();
  }
  return result;
}

Json describe(const GlbMorph& morph, const Point& centre, double size, Buffer& buffer) {
  const std::size_t count = morph.base.size();
  const std::vector<Eigen::Vector3d> from = normals(morph.base, morph.faces, size);
  const std::vector<Eigen::Vector3d> to = normals(morph.part, morph.faces, size);
  const auto position = [&](std::size_t i) { return Point(morph.base[i] - centre); };
  const auto move = [&](std::size_t i) { return Point(morph.part[i] - morph.base[i]); };
  const auto normal = [&](std::size_t i) { return from[i]; };
  const auto turn = [&](std::size_t i) { return Point(to[i] - from[i]); };
  const Json attributes = {{"POSITION", buffer.add(toFloats(count, position), true)},
                           {"NORMAL", buffer.add(toFloats(count, normal), false)}};
  const Json target = {{"POSITION", buffer.add(toFloats(count, move), true)},
                       {"NORMAL", buffer.add(toFloats(count, turn), false)}};
  const Json primitive = {{"attributes", attributes},
                          {"indices", buffer.add(morph.faces)},
                          {"mode", kTriangles},
                          {"targets", Json::array({target})}};
  Json gltf = {{"asset", {{"version", "2.0"}, {"generator", "Graftsman"}}}, {"scene", 0}};
  gltf["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
  gltf["nodes"] = Json::array(
      {{{"mesh", 0}, {"name", morph.name}, {"translation", {centre.x(), centre.y(), centre.z()}}}});
  gltf["meshes"] = Json::array({{{"name", morph.name},
                                 {"primitives", Json::array({primitive})},
                                 {"weights", Json::array({morph.weight})},
                                 {"extras", {{"targetNames", Json::array({"part"})}}}}});
  const int times = buffer.add(std::vector<float>{0, 2, 4});
  const int weights = buffer.add(std::vector<float>{0, 1, 0});
  const Json sampler = {{"input", times}, {"output", weights}, {"interpolation", "LINEAR"}};
  const Json channel = {{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}};
  gltf["animations"] = Json::array(
      {{{"name", "morph"}, {"channels", Json::array({channel})}, {"samplers", Json::array({sampler})}}});
  buffer.describe(gltf);
  return gltf;
}

void appendNumber(std::string& bytes, std::uint32_t number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

void appendChunk(std::string& bytes, std::string_view content, const char* type, char padding) {
  const std::size_t padded = (content.size() + 3) / 4 * 4;
  appendNumber(bytes, static_cast<std::uint32_t>(padded));
  bytes.append(type, 4);
  bytes += content;
  bytes.append(padded - content.size(), padding);
}

}  // namespace

Result<void> writeGlb(const std::filesystem::path& path, const GlbMorph& morph) {
  assert(morph.base.size() == morph.part.size());
  const auto unwritable = [&](const std::string& why) {
    return fail(ErrorCode::FileUnwritable, printable(path.string(), 400) + ": " + why);
  };
  if (morph.faces.empty() || morph.base.empty()) {
    return fail(ErrorCode::MeshEmpty, printable(path.string(), 400) + ": there is no face to write.");
  }
  Eigen::AlignedBox3d box;
  for (const std::span<const Point> points : {morph.base, morph.part}) {
    for (const Point& p : points) {
      box.extend(p);
    }
  }
  const double size = box.diagonal().norm();
  if (!(size >= kSmallestSize && size <= kGreatestSize)) {
    return unwritable("glTF's single precision cannot hold a model of this size; scale it, or write PLY.");
  }
  constexpr std::size_t kJsonRoom = 1 << 20;
  const std::size_t bytesNeeded = 4 * morph.base.size() * sizeof(Eigen::Vector3f) + morph.faces.size_bytes();
  if (bytesNeeded > std::numeric_limits<std::uint32_t>::max() - kJsonRoom) {
    return unwritable("the mesh is too large for a GLB file (4 GiB); write PLY.");
  }
  Buffer buffer;
  buffer.reserve(bytesNeeded);
  const std::string json =
      describe(morph, box.center(), size, buffer).dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string bytes = "glTF";
  bytes.reserve(bytesNeeded + json.size() + 32);
  appendNumber(bytes, 2);
  const std::size_t total = 12 + 8 + (json.size() + 3) / 4 * 4 + 8 + buffer.bytes().size();
  appendNumber(bytes, static_cast<std::uint32_t>(total));
  appendChunk(bytes, json, "JSON", ' ');
  appendChunk(bytes, buffer.bytes(), "BIN\0", '\0');
  assert(bytes.size() == total);
  return writeFile(path, bytes);
}

}  // namespace graftsman
