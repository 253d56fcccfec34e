#pragma once

#include <QWidget>
#include <functional>
#include <memory>

#include "app/document/document_model.h"
#include "widgets/viewport/camera_view.h"

namespace graftsman {

class VariantPictures;
class VariantsGallery;

/// Variants mode: the gallery of the document's variants. What the person does there becomes commands; the
/// pictures are made by a worker.
class VariantsPage : public QWidget {
  Q_OBJECT

 public:
  /// The result in the window at this moment, and from where it is seen.
  struct View {
    std::shared_ptr<const FusionResults> results;  // null: nothing is shown
    CameraView pane;
  };

  /// `view`: asked for when a picture is to be made.
  VariantsPage(DocumentModel& model, std::function<View()> view, QWidget* parent = nullptr);

  [[nodiscard]] VariantsGallery* gallery() const { return gallery_; }
  [[nodiscard]] VariantPictures* pictures() const { return pictures_; }

  /// The variants that are selected in the gallery, of those that the document has: in the order of
  /// VariantsGallery::selected().
  [[nodiscard]] std::vector<VariantId> selected() const;

  /// Keeps the present state as a variant.
  void keep();
  /// Keeps a state of the undo history; 0: that before the first step.
  void keepState(int historyIndex);
  /// Of what is selected; without a selection nothing happens.
  void apply();
  void toggleStar();
  void remove();
  void giveCurve();       // that of the fusion that is shown
  void giveAdjustment();  // likewise
  void cross();           // exactly two
  /// Draws all pictures as the result looks now.
  void takeView();
  /// Asks for the pictures that are missing, once all that happens at this moment has happened.
  void requestPictures();

 Q_SIGNALS:
  void selectionChanged();
  /// A sentence for the status bar.
  void told(const QString& message);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void connectGallery();
  void push(std::unique_ptr<EditCommand> command);
  void add(std::unique_ptr<EditCommand> command);
  void apply(VariantId id);
  void star(const std::vector<int>& ids, bool starred);
  void showVariants();
  void showPictures();
  void requestNow();
  void setCamera(const View& view);

  DocumentModel& model_;
  std::function<View()> view_;
  VariantsGallery* gallery_;
  VariantPictures* pictures_;
  bool requested_ = false;
};

}  // namespace graftsman
