#include "core/io/mesh_writer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/write_file.h"
#include "core/io/printable.h"

namespace graftsman {
namespace {

constexpr std::size_t kLinesPerLook = 4096;  // at the progress
constexpr std::size_t kLongestNumber = 32;   // characters of a double or an integer
constexpr double kFormatShare = 0.8;         // of the time that writing takes

class MeshFormatter {
 public:
  MeshFormatter(std::span<const Point> points, std::span<const Face> faces, const Progress& progress)
      : points_(points), faces_(faces), progress_(progress) {}

  // Each of these appends the whole file to text_. False: cancelled.
  bool obj() {
    return eachPoint([&](const Point& p) { line("v", p); }) && eachFace([&](const Face& f) {
             text_ += 'f';
             for (const Index v : f) {
               number(v + 1);
             }
             text_ += '\n';
           });
  }

  bool off() {
    text_ += "OFF\n" + std::to_string(points_.size()) + " " + std::to_string(faces_.size()) + " 0\n";
    return eachPoint([&](const Point& p) { line("", p); }) && eachFace([&](const Face& f) { corners(f); });
  }

  bool ply(bool binary) {
    text_ += std::string("ply\nformat ") + (binary ? "binary_little_endian" : "ascii") +
             " 1.0\nelement vertex " + std::to_string(points_.size()) +
             "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
             std::to_string(faces_.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    if (!binary) {
      return eachPoint([&](const Point& p) { line("", p); }) && eachFace([&](const Face& f) { corners(f); });
    }
    return eachPoint([&](const Point& p) {
             for (const double c : p) {
               littleEndian(std::bit_cast<std::uint64_t>(c));
             }
           }) &&
           eachFace([&](const Face& f) {
             text_ += '\3';
             for (const Index v : f) {
               littleEndian(static_cast<std::uint32_t>(v));
             }
           });
  }

  bool stl(bool binary) {
    if (binary) {
      // A header that does not begin with "solid", which would pass for text.
      std::string header = "binary STL written by Graftsman";
      header.resize(80, ' ');
      text_ += header;
      littleEndian(static_cast<std::uint32_t>(faces_.size()));
      return eachFace([&](const Face& f) { binaryFacet(f); });
    }
    text_ += "solid\n";
    const bool finished = eachFace([&](const Face& f) {
      line("facet normal", normal(f));
      text_ += "outer loop\n";
      for (const Index v : f) {
        line("vertex", points_[static_cast<std::size_t>(v)]);
      }
      text_ += "endloop\nendfacet\n";
    });
    text_ += "endsolid\n";
    return finished;
  }

  [[nodiscard]] std::string takeText() { return std::move(text_); }

 private:
  template <class Write>
  bool eachPoint(Write write) {
    return each(points_, 0, write);
  }
  template <class Write>
  bool eachFace(Write write) {
    return each(faces_, points_.size(), write);
  }
  template <class Rows, class Write>
  bool each(const Rows& rows, std::size_t before, Write write) {
    const auto all = static_cast<double>(points_.size() + faces_.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (i % kLinesPerLook == 0 && !progress_.keepGoing(static_cast<double>(before + i) / all)) {
        return false;
      }
      write(rows[i]);
    }
    return true;
  }

  void line(std::string_view keyword, const Point& p) {
    text_ += keyword;
    for (int axis = 0; axis < 3; ++axis) {
      number(p[axis]);
    }
    text_ += '\n';
  }

  void corners(const Face& f) {
    text_ += '3';
    for (const Index v : f) {
      number(v);
    }
    text_ += '\n';
  }

  // With a blank before it, except at the beginning of a line.
  template <class Number>
  void number(Number value) {
    std::array<char, kLongestNumber> digits;
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    if (text_.back() != '\n') {
      text_ += ' ';
    }
    text_.append(static_cast<const char*>(digits.data()), end);
  }

  template <class Bits>
  void littleEndian(Bits bits) {
    std::array<char, sizeof(Bits)> bytes;
    for (std::size_t i = 0; i < sizeof(Bits); ++i) {
      bytes[i] = static_cast<char>(bits >> (8 * i) & 0xff);
    }
    text_.append(bytes.data(), bytes.size());
  }

  void binaryFacet(const Face& f) {
    const auto write = [&](const Point& p) {
      for (const double c : p) {
        littleEndian(std::bit_cast<std::uint32_t>(static_cast<float>(c)));
      }
    };
    write(normal(f));
    for (const Index v : f) {
      write(points_[static_cast<std::size_t>(v)]);
    }
    text_.append(2, '\0');
  }

  // Of length 1; zero for a facet without area. The scaling keeps the products from over- and underflow.
  [[nodiscard]] Point normal(const Face& f) const {
    const Point& a = points_[static_cast<std::size_t>(f[0])];
    Point u = points_[static_cast<std::size_t>(f[1])] / 2 - a / 2;
    Point v = points_[static_cast<std::size_t>(f[2])] / 2 - a / 2;
    for (Point* const edge : {&u, &v}) {
      const double size = edge->cwiseAbs().maxCoeff();
      *edge = size > 0 ? Point(*edge / size) : Point(Point::Zero());
    }
    const Point cross = u.cross(v);
    const double length = cross.norm();
    return length > 0 ? Point(cross / length) : Point(Point::Zero());
  }

  std::span<const Point> points_;
  std::span<const Face> faces_;
  const Progress& progress_;
  std::string text_;
};

Result<void> checkPoints(MeshFormat format, const std::filesystem::path& path, std::span<const Point> points,
                         bool binary) {
  const bool floats = format == MeshFormat::Stl && binary;
  const double limit = floats ? std::numeric_limits<float>::max() : std::numeric_limits<double>::max();
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (!(points[v].cwiseAbs().maxCoeff() <= limit) || !points[v].allFinite()) {
      return fail(ErrorCode::FileUnwritable,
                  printable(path.string(), kLongestPathShown) + ": cannot be written: vertex " +
                      std::to_string(v) + " has a coordinate that " +
                      (points[v].allFinite() ? "is too large for binary STL; choose another format"
                                             : "is not a finite number"));
    }
  }
  return {};
}

}  // namespace

Result<std::string> formatMesh(MeshFormat format, const std::filesystem::path& path,
                               std::span<const Point> points, std::span<const Face> faces,
                               const WriteOptions& options, const Progress& progress) {
  Result<void> checked = checkPoints(format, path, points, options.binary);
  if (!checked) {
    return fail(std::move(checked.error()));
  }
  MeshFormatter formatter(points, faces, progress);
  bool finished = false;
  switch (format) {
    case MeshFormat::Obj:
      finished = formatter.obj();
      break;
    case MeshFormat::Ply:
      finished = formatter.ply(options.binary);
      break;
    case MeshFormat::Stl:
      finished = formatter.stl(options.binary);
      break;
    case MeshFormat::Off:
      finished = formatter.off();
      break;
  }
  if (!finished) {
    return fail(ErrorCode::Cancelled, "Writing was cancelled.");
  }
  return formatter.takeText();
}

Result<void> writeMesh(const std::filesystem::path& path, std::span<const Point> points,
                       std::span<const Face> faces, const WriteOptions& options, const Progress& progress) {
  const Result<MeshFormat> format = formatOf(path);
  if (!format) {
    return fail(format.error());
  }
  const Result<std::string> text =
      formatMesh(*format, path, points, faces, options, progress.span(0, kFormatShare));
  if (!text) {
    return fail(text.error());
  }
  if (!progress.keepGoing(kFormatShare)) {
    return fail(ErrorCode::Cancelled, "Writing was cancelled.");
  }
  return writeFile(path, *text);
}

}  // namespace graftsman
