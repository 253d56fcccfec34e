#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <set>

#include "app/document/document_model.h"
#include "app/document/stage_runner.h"
#include "app/workbench/variants_page.h"
#include "core/sweep/suggest.h"

namespace graftsman {

class JobQueue;
class SuggestionStrip;
class VariantPictures;

/// Fills the strip with suggestions for the fusion that is shown, and takes those that the person wants. They
/// are looked for on a thread of its own while the strip is visible, the loop is closed and no stage runs;
/// the newest state of the fusion wins. Suggestions stay as they are while the fusion is as one of them, or
/// as the state that they were made for: a person can go from one to the next. Lives in the GUI thread, which
/// never waits for it (but in the destructor, for a search to notice that it is to stop).
class Suggester : public QObject {
  Q_OBJECT

 public:
  /// `view`: the result in the window and from where it is seen, asked for when pictures are to be drawn.
  Suggester(DocumentModel& model, StageRunner& runner, SuggestionStrip& strip,
            std::function<VariantsPage::View()> view, QObject* parent = nullptr);
  ~Suggester() override;

  /// A search is under way, or pictures are to come.
  [[nodiscard]] bool busy() const;
  /// Stops the search and the pictures; the next edit, or opening the strip again, goes on.
  void cancel();
  /// Draws the pictures from where the result is seen now.
  void takeView();
  /// The same once the view has come to rest.
  void moveView();
  /// Looks again at what is to be done, once all that happens at this moment has happened.
  void refresh();

 Q_SIGNALS:
  void busyChanged();
  /// A sentence for the status bar.
  void told(const QString& message);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  // Suggestions with the state of the fusion that they were made for.
  struct Found {
    Fusion fusion;
    Suggestions suggestions;
    std::optional<Error> error;       // why there are none
    VariantList states;               // of each candidate, as pictures want it; id: its number, from 1 on
    std::set<std::size_t> taken;      // those that the person took
    std::vector<std::size_t> chosen;  // those that are shown, in their order
  };
  struct Search;

  void refreshNow();
  void search(const Fusion& fusion);
  void finish(const Fusion& fusion, Search search);
  void stopSearch();
  void showNone(const QString& reason);
  [[nodiscard]] bool covers(const Fusion& fusion) const;
  [[nodiscard]] std::optional<std::size_t> candidateOf(const Fusion& fusion) const;
  void setCamera();
  void showFound();
  void showTaken();
  void showPictures();
  void requestPictures();
  void take(int id);

  DocumentModel& model_;
  StageRunner& runner_;
  SuggestionStrip& strip_;
  std::function<VariantsPage::View()> view_;
  JobQueue* jobs_;
  VariantPictures* pictures_;
  QTimer refresh_;
  QTimer cameraRests_;
  std::shared_ptr<const Outcome> outcome_;  // of the last run
  std::optional<Found> found_;
  std::optional<Fusion> searching_;          // what the search under way is for
  std::optional<Fusion> cancelled_;          // what none is wanted for
  std::shared_ptr<std::atomic<bool>> stop_;  // the search under way
  std::shared_ptr<const NearestSurface> base_;
};

}  // namespace graftsman
