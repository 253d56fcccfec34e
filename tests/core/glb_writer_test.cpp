#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

#include <QTemporaryDir>
#include <QtTest>
#include <cmath>
#include <cstring>
#include <fstream>

#include "core/io/glb_writer.h"
#include "tests/support/shapes.h"

using namespace graftsman;
namespace fs = std::filesystem;

namespace {

struct Read {
  tinygltf::Model model;
  std::string trouble;
};

Read readBack(const fs::path& path) {
  Read read;
  tinygltf::TinyGLTF reader;
  std::string warning;
  if (!reader.LoadBinaryFromFile(&read.model, &read.trouble, &warning, path.string()) || !warning.empty()) {
    read.trouble += "failed " + warning;
  }
  return read;
}

// An accessor's floats.
std::vector<Eigen::Vector3f> vectors(const tinygltf::Model& model, int number) {
  const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(number)];
  const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
  std::vector<Eigen::Vector3f> result(accessor.count);
  std::memcpy(result.data(), model.buffers[0].data.data() + view.byteOffset, view.byteLength);
  return result;
}

Point translation(const tinygltf::Model& model) {
  const std::vector<double>& t = model.nodes[0].translation;
  return {t[0], t[1], t[2]};
}

std::vector<Point> stretched(const std::vector<Point>& points, const Point& factors, const Point& shift) {
  std::vector<Point> result;
  for (const Point& p : points) {
    result.emplace_back(p.cwiseProduct(factors) + shift);
  }
  return result;
}

}  // namespace

class GlbWriterTest : public QObject {
  Q_OBJECT

 private:
  QTemporaryDir folder_;

  [[nodiscard]] fs::path file() const { return fs::path(folder_.path().toStdString()) / "tile.glb"; }

 private Q_SLOTS:
  void bothShapesAndTheirNormalsComeBack() {
    const auto sphere = shapes::icosphere(2);
    const std::vector<Point> part = stretched(sphere->points(), {1, 1, 2}, {0, 0, 0.5});
    QVERIFY(writeGlb(file(), {sphere->points(), part, sphere->faces(), 0.25, "ball \"Ü\""}));
    const auto [model, trouble] = readBack(file());
    QVERIFY2(trouble.empty(), trouble.c_str());
    QCOMPARE(model.asset.version, std::string("2.0"));
    QCOMPARE(model.meshes.size(), std::size_t{1});
    const tinygltf::Mesh& mesh = model.meshes[0];
    QCOMPARE(mesh.name, std::string("ball \"Ü\""));
    QVERIFY(mesh.weights == std::vector<double>{0.25});
    QCOMPARE(mesh.extras.Get("targetNames").Get(0).Get<std::string>(), std::string("part"));
    QCOMPARE(mesh.primitives.size(), std::size_t{1});
    const tinygltf::Primitive& primitive = mesh.primitives[0];
    QCOMPARE(primitive.mode, TINYGLTF_MODE_TRIANGLES);
    QCOMPARE(primitive.targets.size(), std::size_t{1});

    const auto positions = vectors(model, primitive.attributes.at("POSITION"));
    const auto normals = vectors(model, primitive.attributes.at("NORMAL"));
    const auto moves = vectors(model, primitive.targets[0].at("POSITION"));
    const auto turns = vectors(model, primitive.targets[0].at("NORMAL"));
    const Point centre = translation(model);
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Point base = positions[i].cast<double>() + centre;
      QVERIFY((base - sphere->points()[i]).norm() < 1e-6);
      QVERIFY((base + moves[i].cast<double>() - part[i]).norm() < 1e-6);
      QVERIFY(std::abs(normals[i].norm() - 1) < 1e-6);
      QVERIFY(normals[i].cast<double>().dot(sphere->points()[i]) > 0.99);
      const Point& p = sphere->points()[i];
      const Point ellipsoid = Point(p.x(), p.y(), p.z() / 2).normalized();
      QVERIFY(std::abs((normals[i] + turns[i]).norm() - 1) < 1e-6);
      QVERIFY((normals[i] + turns[i]).cast<double>().dot(ellipsoid) > 0.98);
    }
  }

  void theWeightIsAnimated() {
    const auto sphere = shapes::icosphere(1);
    const std::vector<Point> part = stretched(sphere->points(), {1, 1, 2}, {0, 0, 0});
    QVERIFY(writeGlb(file(), {sphere->points(), part, sphere->faces()}));
    const auto [model, trouble] = readBack(file());
    QVERIFY2(trouble.empty(), trouble.c_str());
    QCOMPARE(model.animations.size(), std::size_t{1});
    const tinygltf::Animation& animation = model.animations[0];
    QCOMPARE(animation.name, std::string("morph"));
    QCOMPARE(animation.channels.size(), std::size_t{1});
    QCOMPARE(animation.channels[0].target_path, std::string("weights"));
    QCOMPARE(animation.channels[0].target_node, 0);
    QCOMPARE(animation.samplers.size(), std::size_t{1});
    const tinygltf::AnimationSampler& sampler = animation.samplers[0];
    QCOMPARE(sampler.interpolation, std::string("LINEAR"));
    const auto numbers = [&](int accessorNumber) {
      const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(accessorNumber)];
      const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
      std::vector<float> result(accessor.count);
      std::memcpy(result.data(), model.buffers[0].data.data() + view.byteOffset, view.byteLength);
      return result;
    };
    QVERIFY(numbers(sampler.input) == (std::vector<float>{0, 2, 4}));
    const tinygltf::Accessor& times = model.accessors[static_cast<std::size_t>(sampler.input)];
    QVERIFY(times.minValues == std::vector<double>{0} && times.maxValues == std::vector<double>{4});
    // One weight, that of the one morph target, for each time.
    QVERIFY(numbers(sampler.output) == (std::vector<float>{0, 1, 0}));
  }

  void theFacesComeBack() {
    const auto grid = shapes::grid(3);
    QVERIFY(writeGlb(file(), {grid->points(), grid->points(), grid->faces()}));
    const auto [model, trouble] = readBack(file());
    QVERIFY2(trouble.empty(), trouble.c_str());
    const tinygltf::Accessor& accessor =
        model.accessors[static_cast<std::size_t>(model.meshes[0].primitives[0].indices)];
    QCOMPARE(accessor.componentType, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    QCOMPARE(accessor.type, TINYGLTF_TYPE_SCALAR);
    QCOMPARE(accessor.count, 3 * grid->faces().size());
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(accessor.bufferView)];
    QCOMPARE(view.target, TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    std::vector<Face> faces(grid->faces().size());
    std::memcpy(faces.data(), model.buffers[0].data.data() + view.byteOffset, view.byteLength);
    QVERIFY(faces == grid->faces());
  }

  void accessorsSayTheirRangeAndLieWhereTheFormatDemands() {
    const auto sphere = shapes::icosphere(1);
    const std::vector<Point> part = stretched(sphere->points(), {1, 3, 1}, {1, 0, 0});
    QVERIFY(writeGlb(file(), {sphere->points(), part, sphere->faces(), 0, "odd"}));
    const auto [model, trouble] = readBack(file());
    QVERIFY2(trouble.empty(), trouble.c_str());
    const tinygltf::Primitive& primitive = model.meshes[0].primitives[0];
    for (const int number : {primitive.attributes.at("POSITION"), primitive.targets[0].at("POSITION")}) {
      const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(number)];
      Eigen::AlignedBox3f box;
      for (const Eigen::Vector3f& v : vectors(model, number)) {
        box.extend(v);
      }
      for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(accessor.minValues[i] == static_cast<double>(box.min()[static_cast<Eigen::Index>(i)]));
        QVERIFY(accessor.maxValues[i] == static_cast<double>(box.max()[static_cast<Eigen::Index>(i)]));
      }
    }
    std::size_t end = 0;
    for (const tinygltf::BufferView& view : model.bufferViews) {
      QCOMPARE(view.byteOffset % 4, std::size_t{0});
      QCOMPARE(view.byteOffset, end);
      end = view.byteOffset + view.byteLength;
    }
    QCOMPARE(model.buffers[0].data.size(), end);
    QCOMPARE(fs::file_size(file()) % 4, std::uintmax_t{0});
    std::ifstream stream(file(), std::ios::binary);
    std::array<std::uint32_t, 3> head = {};
    stream.read(reinterpret_cast<char*>(head.data()), sizeof(head));
    QVERIFY((head ==
             std::array<std::uint32_t, 3>{0x46546C67, 2, static_cast<std::uint32_t>(fs::file_size(file()))}));
  }

  void aSmallModelFarFromTheOriginKeepsItsShape() {
    const auto sphere = shapes::icosphere(1);
    const Point shift(100, 200, 300);
    const std::vector<Point> points = stretched(sphere->points(), {1e-4, 1e-4, 1e-4}, shift);
    QVERIFY(writeGlb(file(), {points, points, sphere->faces()}));
    const auto [model, trouble] = readBack(file());
    QVERIFY2(trouble.empty(), trouble.c_str());
    const auto positions = vectors(model, model.meshes[0].primitives[0].attributes.at("POSITION"));
    for (std::size_t i = 0; i < points.size(); ++i) {
      QVERIFY((positions[i].cast<double>() - (points[i] - translation(model))).norm() < 1e-11);
    }
  }

  void aVertexWithoutAFaceStillHasAUnitNormal() {
    const std::vector<Point> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};
    const std::vector<Face> faces = {{0, 1, 2}};
    QVERIFY(writeGlb(file(), {points, points, faces}));
    const auto [model, trouble] = readBack(file());
    QVERIFY2(trouble.empty(), trouble.c_str());
    for (const Eigen::Vector3f& n : vectors(model, model.meshes[0].primitives[0].attributes.at("NORMAL"))) {
      QVERIFY(n == Eigen::Vector3f::UnitZ());
    }
  }

  void aMeshWithoutFacesIsRefused() {
    const std::vector<Point> points = {{0, 0, 0}};
    QCOMPARE(writeGlb(file(), {points, points, {}}).error().code, ErrorCode::MeshEmpty);
  }

  void aSizeBeyondFloatsIsRefused() {
    const auto grid = shapes::grid(1);
    for (const double size : {1e-40, 1e40, 0.0}) {
      const std::vector<Point> points = stretched(grid->points(), {size, size, size}, {0, 0, 0});
      QCOMPARE(writeGlb(file(), {points, points, grid->faces()}).error().code, ErrorCode::FileUnwritable);
    }
  }

  void aFolderThatDoesNotExistIsRefused() {
    const auto grid = shapes::grid(1);
    QCOMPARE(writeGlb("/no/such/folder/a.glb", {grid->points(), grid->points(), grid->faces()}).error().code,
             ErrorCode::FileUnwritable);
  }
};

QTEST_APPLESS_MAIN(GlbWriterTest)
#include "glb_writer_test.moc"
