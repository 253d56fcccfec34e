#include "app/workbench/variant_pictures.h"

#include <QColorSpace>
#include <QMetaObject>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "widgets/theme/theme.h"
#include "widgets/viewport/camera_view.h"

namespace graftsman {
namespace {

// Twice the size that the gallery shows, for screens with small pixels.
constexpr PictureSize kSize{384, 288};
// Of the picture, at each edge.
constexpr double kMargin = 0.06;

Colour colour(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

PictureShading shadingFor(bool dark) {
  QPalette palette;
  palette.setColor(QPalette::Window, dark ? Qt::black : Qt::white);
  const Theme theme = themeFor(palette);
  PictureShading shading;
  shading.mesh = colour(theme.mesh);
  shading.backgroundTop = colour(theme.backgroundTop);
  shading.backgroundBottom = colour(theme.backgroundBottom);
  return shading;
}

QImage toImage(const Picture& picture) {
  static_assert(sizeof(Colour) == 3);
  QImage image = QImage(picture.pixels.data()->data(), picture.size.width, picture.size.height,
                        3 * picture.size.width, QImage::Format_RGB888)
                     .convertToFormat(QImage::Format_RGB32);
  image.setColorSpace(QColorSpace::SRgb);  // as it is once read from its file
  return image;
}

bool equal(const PictureCamera& a, const PictureCamera& b) {
  return a.position == b.position && a.pivot == b.pivot && a.up == b.up && a.viewAngle == b.viewAngle;
}

}  // namespace

PictureCamera pictureCamera(const CameraView& view, std::span<const Point> points, double aspect) {
  const Eigen::Vector3d right = view.right();
  const Eigen::Vector3d up = view.up();
  // Tangents of the angles between the camera's direction and the points, as far as the pane shows them.
  const double tallest = std::tan(CameraView::kAngle / 2);
  const Eigen::Array2d pane(tallest * view.size.width() / std::max(1.0, view.size.height()), tallest);
  Eigen::AlignedBox2d seen;
  for (const Point& point : points) {
    const double depth = view.depth(point);
    if (depth > 0) {
      const Eigen::Vector3d d = (point - view.camera.position) / depth;
      const Eigen::Array2d at(d.dot(right), d.dot(up));
      seen.extend(at.max(-pane).min(pane).matrix());
    }
  }
  if (seen.isEmpty() || !(seen.sizes().maxCoeff() > 0)) {
    seen = Eigen::AlignedBox2d((-pane).matrix(), pane.matrix());
  }
  PictureCamera camera;
  const Eigen::Vector2d middle = seen.center();
  const Eigen::Vector3d aside =
      (view.camera.pivot - view.camera.position).norm() * (middle.x() * right + middle.y() * up);
  camera.position = view.camera.position + aside;
  camera.pivot = view.camera.pivot + aside;
  camera.up = up;
  const double half = std::max(seen.sizes().y(), seen.sizes().x() / aspect) / 2;
  camera.viewAngle = 2 * std::atan(half / (1 - 2 * kMargin));
  return camera;
}

VariantPictures::VariantPictures(QObject* parent, std::size_t kept)
    : QObject(parent), kept_(kept), worker_([this] { work(); }) {}

VariantPictures::~VariantPictures() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = stop_ = true;
  }
  wake_.notify_one();
  worker_.join();
}

void VariantPictures::setCamera(const PictureCamera& camera) {
  if (!camera_ || !equal(*camera_, camera)) {
    const bool first = !camera_;
    camera_ = camera;
    if (!first) {
      renewLook();
    }
  }
}

void VariantPictures::setDark(bool dark) {
  if (std::exchange(dark_, dark) != dark) {
    renewLook();
  }
}

// What is under way is of the old one.
void VariantPictures::renewLook() {
  ++look_;
  cancel();
}

VariantPictures::Key VariantPictures::keyOf(const Variant& variant) {
  Key key;
  for (const FusionId id : upstreamOf(variant.fusions, variant.shown)) {
    key.push_back(find(variant.fusions, id));
  }
  return key;
}

void VariantPictures::request(const VariantList& variants,
                              const std::shared_ptr<const FusionResults>& known) {
  prune(variants);
  std::vector<Job> jobs;
  std::set<Key> asked;
  for (const auto& variant : variants) {
    Key key = keyOf(*variant);
    const auto found = entries_.find(key);
    const bool there = found != entries_.end();
    const bool unread = there && found->second.shown.picture.isNull() && !found->second.png.empty();
    const bool current = there && found->second.look == look_ && !unread;
    if (key.empty() || current || !(unread || camera_) || !asked.insert(key).second) {
      continue;
    }
    jobs.push_back({std::move(key), variant->fusions, variant->shown, unread ? found->second.look : look_,
                    camera_, dark_, unread ? found->second.png : std::string(), known});
  }
  {
    const std::lock_guard lock(mutex_);
    const auto isRunning = [&](const Job& job) { return running_ == std::pair(job.key, job.look); };
    stop_ = stop_ || (running_ && std::none_of(jobs.begin(), jobs.end(), isRunning));
    if (!stop_) {
      std::erase_if(jobs, isRunning);
    }
    waiting_ = std::move(jobs);
  }
  wake_.notify_one();
  setMissing(static_cast<int>(asked.size()));
}

void VariantPictures::cancel() {
  {
    const std::lock_guard lock(mutex_);
    waiting_.clear();
    stop_ = running_.has_value();
  }
  setMissing(0);
}

VariantPictures::Shown VariantPictures::shown(const Variant& variant) const {
  const auto found = entries_.find(keyOf(variant));
  return found == entries_.end() ? Shown() : found->second.shown;
}

std::map<VariantId, std::string> VariantPictures::files(const VariantList& variants) const {
  std::map<VariantId, std::string> files;
  for (const auto& variant : variants) {
    const auto found = entries_.find(keyOf(*variant));
    if (found != entries_.end() && !found->second.png.empty()) {
      files[variant->id] = found->second.png;
    }
  }
  return files;
}

void VariantPictures::restore(const VariantList& variants, std::map<VariantId, std::string> files) {
  ++look_;
  cancel();
  entries_.clear();
  camera_.reset();
  for (const auto& variant : variants) {
    if (const auto found = files.find(variant->id); found != files.end()) {
      entries_[keyOf(*variant)] = {variant->fusions, look_, {}, std::move(found->second)};
    }
  }
}

void VariantPictures::restoreLook(const std::optional<PictureCamera>& camera, bool dark) {
  camera_ = camera;
  if (dark != dark_) {
    ++look_;  // they stay shown until they are drawn anew
  }
}

// Pictures that no variant has stay for undo, unless they are many.
void VariantPictures::prune(const VariantList& variants) {
  if (entries_.size() <= variants.size() + kept_) {
    return;
  }
  std::set<Key> used;
  for (const auto& variant : variants) {
    used.insert(keyOf(*variant));
  }
  std::erase_if(entries_, [&](const auto& entry) { return !used.contains(entry.first); });
}

void VariantPictures::work() {
  Evaluated known;  // what the next picture's fusion is computed from
  std::unique_lock lock(mutex_);
  while (true) {
    if (waiting_.empty()) {
      known = {};
    }
    wake_.wait(lock, [this] { return !waiting_.empty() || quit_; });
    if (quit_) {
      return;
    }
    const Job job = std::move(waiting_.back());
    waiting_.pop_back();
    running_ = {job.key, job.look};
    stop_ = false;
    lock.unlock();
    Entry entry = make(job, known);
    lock.lock();
    running_.reset();
    if (stop_) {
      continue;
    }
    done_.emplace_back(job.key, std::move(entry));
    if (done_.size() == 1) {
      QMetaObject::invokeMethod(
          this, [this] { deliver(); }, Qt::QueuedConnection);
    }
  }
}

VariantPictures::Entry VariantPictures::make(const Job& job, Evaluated& known) {
  Entry entry{job.fusions, job.look, {}, job.png};
  if (!job.png.empty() && entry.shown.picture.loadFromData(reinterpret_cast<const uchar*>(job.png.data()),
                                                           static_cast<int>(job.png.size()))) {
    return entry;
  }
  entry.png.clear();
  if (!job.camera) {
    entry.look = -1;
    return entry;
  }
  if (known.fusions.empty() && job.known) {
    known.fusions[job.id].results = *job.known;
  }
  const Evaluation evaluation = evaluate(job.fusions, job.id, known, Progress([this](double) {
                                           const std::lock_guard lock(mutex_);
                                           return !stop_;
                                         }));
  const FusionResults& results = evaluation.results;
  const TriangleMesh* base = evaluation.fusion.inputs.base.get();
  if (!results.fused) {
    entry.shown.problem = results.error ? QString::fromStdString(results.error->message)
                                        : tr("The loop is open: there is no result.");
  }
  {
    const std::lock_guard lock(mutex_);
    if (stop_ || (!results.fused && base == nullptr)) {
      return entry;
    }
  }
  const PictureShading shading = shadingFor(job.dark);
  const Picture picture =
      results.fused ? draw(results.fused->points, results.fused->faces(), *job.camera, kSize, shading)
                    : draw(base->points(), base->faces(), *job.camera, kSize, shading);
  entry.shown.picture = toImage(picture);
  entry.png = formatPng(picture).value_or(std::string());
  return entry;
}

// In the GUI thread.
void VariantPictures::deliver() {
  std::vector<std::pair<Key, Entry>> done;
  int left = 0;
  {
    const std::lock_guard lock(mutex_);
    done.swap(done_);
    left = static_cast<int>(waiting_.size()) + (running_ ? 1 : 0);
  }
  for (auto& [key, entry] : done) {
    // One that overtook a change of the camera, or came from the file, is shown until there is a newer one.
    Entry& kept = entries_[std::move(key)];
    if (kept.look <= entry.look || kept.shown.picture.isNull()) {
      kept = std::move(entry);
    }
  }
  setMissing(left);
  Q_EMIT drawn();
}

void VariantPictures::setMissing(int missing) {
  if (std::exchange(missing_, missing) != missing) {
    Q_EMIT missingChanged(missing);
  }
}

}  // namespace graftsman
