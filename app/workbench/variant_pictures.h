#pragma once

#include <QImage>
#include <QObject>
#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/picture/draw.h"
#include "core/project/evaluate.h"

namespace graftsman {

struct CameraView;

/// The camera of a picture of this aspect (width / height) that shows what a pane's view shows of the points,
/// tightly. Points: N×3.
[[nodiscard]] PictureCamera pictureCamera(const CameraView& view, std::span<const Point> points,
                                          double aspect);

/// Pictures of variants, made on a thread of its own, all from one camera. A picture is made once for what it
/// shows: variants of the same fusions share it, and one that comes back by undo has it at once. Lives in the
/// GUI thread, which never waits for it (but in the destructor, for a run to notice that it is to stop).
class VariantPictures : public QObject {
  Q_OBJECT

 public:
  /// `kept`: how many pictures that no variant has any more are kept, for undo.
  explicit VariantPictures(QObject* parent = nullptr, std::size_t kept = 200);
  ~VariantPictures() override;

  struct Shown {
    QImage picture;   // null: there is none (yet)
    QString problem;  // why the variant has no result; empty: it has one, or is not computed yet
  };

  /// From where, and before which background. Pictures from elsewhere are out of date from now on.
  void setCamera(const PictureCamera& camera);
  void setDark(bool dark);
  /// The camera, once there is one.
  [[nodiscard]] const std::optional<PictureCamera>& camera() const { return camera_; }
  [[nodiscard]] bool dark() const { return dark_; }

  /// Asks for the pictures of these variants that are missing or out of date: newest first, what was asked
  /// for before and is not in the list is forgotten. `known`: results that one of them may have, or null.
  void request(const VariantList& variants, const std::shared_ptr<const FusionResults>& known);
  /// Forgets what is asked for and stops what is under way. The next request asks again.
  void cancel();
  /// How many are asked for and not there yet.
  [[nodiscard]] int missing() const { return missing_; }

  [[nodiscard]] Shown shown(const Variant& variant) const;

  /// PNG bytes of those that have a picture, for the project's file.
  [[nodiscard]] std::map<VariantId, std::string> files(const VariantList& variants) const;
  /// Forgets all pictures and takes those of a file, made from the camera and background that are set next.
  void restore(const VariantList& variants, std::map<VariantId, std::string> files);
  /// Of the restored pictures. Without camera they count as up to date whatever camera is set first.
  void restoreLook(const std::optional<PictureCamera>& camera, bool dark);

 Q_SIGNALS:
  /// The picture of fusions came: shown() of their variants is new.
  void drawn();
  /// missing() changed.
  void missingChanged(int missing);

 private:
  // What a picture depends on: the fusions that the shown one is made of, itself the last.
  using Key = std::vector<const Fusion*>;
  struct Entry {
    FusionList fusions;  // so that no other fusion takes the address of one
    int look = 0;        // −1: there is nothing to be shown
    Shown shown;
    std::string png;
  };
  struct Job {
    Key key;
    FusionList fusions;
    FusionId id = 0;
    int look = 0;
    std::optional<PictureCamera> camera;
    bool dark = false;
    std::string png;  // to be read instead of drawn
    std::shared_ptr<const FusionResults> known;
  };

  [[nodiscard]] static Key keyOf(const Variant& variant);
  void renewLook();
  void prune(const VariantList& variants);
  void work();
  [[nodiscard]] Entry make(const Job& job, Evaluated& known);
  void deliver();
  void setMissing(int missing);

  std::size_t kept_;
  std::map<Key, Entry> entries_;
  std::optional<PictureCamera> camera_;
  bool dark_ = false;
  int look_ = 0;  // a number for camera and background
  int missing_ = 0;

  std::mutex mutex_;  // of what follows, but the thread
  std::condition_variable wake_;
  std::vector<Job> waiting_;                    // the next is the last
  std::optional<std::pair<Key, int>> running_;  // with its look
  std::vector<std::pair<Key, Entry>> done_;
  bool stop_ = false;
  bool quit_ = false;
  std::thread worker_;
};

}  // namespace graftsman
