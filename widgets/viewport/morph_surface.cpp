#include "widgets/viewport/morph_surface.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "core/base/parallel.h"
#include "core/base/vector_clones.h"

namespace graftsman {
namespace {

// From here on starting threads costs less than it saves.
constexpr std::size_t kManyVertices = 1 << 18;
constexpr std::size_t kGrain = 1 << 15;
// Weights at a time: they stay in the nearest cache.
constexpr std::size_t kBlock = 512;

void write(const Point& point, const Point& centre, float* to) {
  Eigen::Vector3f::Map(to) = (point - centre).cast<float>();
}

// Eq. 1; exactly `base` where f is 0 and `part` where it is 1.
GRAFTSMAN_VECTOR_CLONES
void mix(const float* weights, const float* part, const float* base, float* out, std::size_t size) {
  std::array<float, 3 * kBlock> weight;
  for (std::size_t j = 0; j < size; ++j) {
    weight[3 * j] = weights[j];
    weight[3 * j + 1] = weights[j];
    weight[3 * j + 2] = weights[j];
  }
  for (std::size_t j = 0; j < 3 * size; ++j) {
    out[j] = weight[j] * part[j] + (1 - weight[j]) * base[j];
  }
}

template <class Body>
void inRanges(std::size_t count, const Body& body) {
  if (count <= kManyVertices) {
    body(0, count);
  } else {
    parallelRanges(count, kGrain, body);
  }
}

}  // namespace

MorphSurface::MorphSurface(std::shared_ptr<const Join> join, std::shared_ptr<const CombinedTile> combined,
                           const FCF& curve)
    : join_(std::move(join)),
      combined_(std::move(combined)),
      layout_(layOut(*join_, *combined_)),
      seamEdges_(findSeamEdges(layout_, *combined_)),
      fans_(findFans(combined_->faces, layout_.tileSize)) {
  place();

  const float perLength = 1 / unit_;
  std::vector<AreaVector> sums(layout_.restVertices.size(), AreaVector::Zero());
  addAreas(positions_.data(), layout_.restFaces, perLength, sums);
  for (Index v = 0; v < layout_.farCount; ++v) {
    writeNormal(sums[static_cast<std::size_t>(v)], normalsAt(v));
  }
  ringRest_.assign(sums.begin() + layout_.ringBegin(), sums.end());
  rim_.resize(static_cast<std::size_t>(layout_.ringCount) + static_cast<std::size_t>(layout_.seamSize));
  faceAreas_.resize(combined_->faces.size());
  setCurve(curve);
  findCoarseFaces();
}

// The ring and the seam are borders of theirs, and keep all vertices: the rim between them is drawn whole.
void MorphSurface::findCoarseFaces() {
  const auto grid = [](const Eigen::AlignedBox3d& box) {
    return box.isEmpty() ? ClusterGrid() : ClusterGrid::across(box.sizes().maxCoeff(), box.min());
  };
  const MorphSheet rest = this->rest();
  coarseRest_ = coarsen(rest.positions, rest.normals, rest.vertexCount, rest.faces, grid(rest.box));
  const MorphSheet tile = this->tile();
  coarseTile_ = coarsen(tile.positions, tile.normals, tile.vertexCount, tile.faces, grid(tile.box));
}

void MorphSurface::place() {
  const std::size_t tileSize = combined_->s.size();
  for (const Index v : layout_.restVertices) {
    restBox_.extend(join_->points[static_cast<std::size_t>(v)]);
  }
  for (std::size_t k = 0; k < tileSize; ++k) {
    tileBox_.extend(combined_->part[k]);
    tileBox_.extend(combined_->base[k]);
  }
  const Eigen::AlignedBox3d all = restBox_.merged(tileBox_);
  centre_ = all.center();
  unit_ = std::max(static_cast<float>(all.diagonal().norm()), std::numeric_limits<float>::min());

  // No seam lies at NaN: the first curve moves it, wherever it is.
  positions_.assign(3 * static_cast<std::size_t>(layout_.vertexCount()) + 1,
                    std::numeric_limits<float>::quiet_NaN());
  normals_.assign(positions_.size(), 0);
  weights_.assign(tileSize, 0);
  part_.resize(3 * tileSize);
  base_.resize(3 * tileSize);
  for (std::size_t v = 0; v < layout_.restVertices.size(); ++v) {
    write(join_->points[static_cast<std::size_t>(layout_.restVertices[v])], centre_, &positions_[3 * v]);
  }
  for (std::size_t k = 0; k < tileSize; ++k) {
    write(combined_->part[k], centre_, &part_[3 * k]);
    write(combined_->base[k], centre_, &base_[3 * k]);
  }

  for (Index v = layout_.ringBegin(); v < layout_.seamCopiesBegin(); ++v) {
    rimBox_.extend(
        join_->points[static_cast<std::size_t>(layout_.restVertices[static_cast<std::size_t>(v)])]);
  }
  for (std::size_t k = 0; k < static_cast<std::size_t>(layout_.seamSize); ++k) {
    rimBox_.extend(combined_->part[k]);
    rimBox_.extend(combined_->base[k]);
  }
  for (Eigen::AlignedBox3d* box : {&restBox_, &rimBox_, &tileBox_}) {
    if (!box->isEmpty()) {
      box->translate(-centre_);
    }
  }
}

bool MorphSurface::setCurve(const FCF& curve) {
  curve_ = curve;
  const std::size_t tileSize = combined_->s.size();
  inRanges(tileSize, [this](std::size_t begin, std::size_t end) { blendRange(begin, end); });
  const bool seamMoved = moveSeam();
  if (seamMoved) {
    findRimNormals();
  }
  inRanges(combined_->faces.size(), [this](std::size_t begin, std::size_t end) {
    const float* const positions = positionsAt(layout_.tileBegin());
    const float perLength = 1 / unit_;
    for (std::size_t f = begin; f < end; ++f) {
      faceAreas_[f] = areaOf(positions, combined_->faces[f], perLength);
    }
  });
  inRanges(tileSize, [this](std::size_t begin, std::size_t end) { findTileNormals(begin, end); });
  std::memcpy(normalsAt(layout_.seamCopiesBegin()), normalsAt(layout_.tileBegin()),
              3 * sizeof(float) * static_cast<std::size_t>(layout_.seamSize));
  return seamMoved;
}

void MorphSurface::blendRange(std::size_t begin, std::size_t end) {
  std::array<double, kBlock> exact;
  float* const positions = positionsAt(layout_.tileBegin());
  for (; begin < end; begin += kBlock) {
    const std::size_t size = std::min(kBlock, end - begin);
    curve_.evaluate(std::span(combined_->s).subspan(begin, size), std::span(exact).first(size));
    std::copy_n(exact.begin(), size, weights_.begin() + static_cast<std::ptrdiff_t>(begin));
    mix(&weights_[begin], &part_[3 * begin], &base_[3 * begin], positions + 3 * begin, size);
  }
}

// Brings the copies of the seam to the tile's; true if they were elsewhere.
bool MorphSurface::moveSeam() {
  const std::size_t bytes = 3 * sizeof(float) * static_cast<std::size_t>(layout_.seamSize);
  float* const copies = positionsAt(layout_.seamCopiesBegin());
  const float* const seam = positionsAt(layout_.tileBegin());
  if (std::memcmp(copies, seam, bytes) == 0) {
    return false;
  }
  std::memcpy(copies, seam, bytes);
  return true;
}

void MorphSurface::findRimNormals() {
  std::fill(rim_.begin(), rim_.end(), AreaVector::Zero());
  addAreas(positionsAt(layout_.ringBegin()), layout_.rimFaces, 1 / unit_, rim_);
  for (Index r = 0; r < layout_.ringCount; ++r) {
    const auto k = static_cast<std::size_t>(r);
    writeNormal(ringRest_[k] + rim_[k], normalsAt(layout_.ringBegin() + r));
  }
}

void MorphSurface::findTileNormals(std::size_t begin, std::size_t end) {
  const Index* const first = fans_.first.data();
  const Index* const faces = fans_.faces.data();
  const AreaVector* const areas = faceAreas_.data();
  float* const normals = normalsAt(layout_.tileBegin());
  const auto seamSize = static_cast<std::size_t>(layout_.seamSize);
  for (std::size_t k = begin; k < end; ++k) {
    AreaVector sum = AreaVector::Zero();
    if (k < seamSize) {
      sum = rim_[static_cast<std::size_t>(layout_.ringCount) + k];
    }
    for (Index i = first[k]; i < first[k + 1]; ++i) {
      sum += areas[faces[i]];
    }
    writeNormal(sum, normals + 3 * k);
  }
}

MorphSheet MorphSurface::sheet(Index first, Index end, std::span<const Face> faces,
                               const Eigen::AlignedBox3d& box, const CoarseFaces* coarse) const {
  const std::ptrdiff_t offset = std::ptrdiff_t{3} * first;
  return {positions_.data() + offset, normals_.data() + offset, end - first, faces, box, coarse};
}

MorphSheet MorphSurface::rest() const {
  return sheet(0, layout_.seamCopiesBegin(), layout_.restFaces, restBox_, &coarseRest_);
}

MorphSheet MorphSurface::rim() const {
  return sheet(layout_.ringBegin(), layout_.tileBegin(), layout_.rimFaces, rimBox_, nullptr);
}

MorphSheet MorphSurface::tile() const {
  return sheet(layout_.tileBegin(), layout_.vertexCount(), combined_->faces, tileBox_, &coarseTile_);
}

}  // namespace graftsman
