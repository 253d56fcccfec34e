#pragma once

#include <QWidget>
#include <array>
#include <functional>
#include <memory>

#include "app/document/document_model.h"
#include "app/workbench/comparison.h"
#include "app/workbench/variants_page.h"
#include "widgets/viewport/viewport.h"

class QButtonGroup;
class QSlider;
class QToolButton;
class QVariantAnimation;

namespace graftsman {

class PaneFrame;
class SurfacePane;

/// Two variants, or one and the present state, beside each other, by their distance, or the one becoming the
/// other. Follows the document: what is renamed or changed is shown so; where one of the two is gone, the
/// window closes.
class CompareWindow : public QWidget {
  Q_OBJECT

 public:
  /// `view`: asked for once, for where the result is seen from. Both panes begin there.
  CompareWindow(DocumentModel& model, const std::function<VariantsPage::View()>& view, QWidget* parent);
  ~CompareWindow() override;

  /// Compares `b` with `a`; 0 stands for the present state. Precondition: both are there.
  void compare(VariantId a, VariantId b);

  enum class Mode { SideBySide, Difference, Morph };
  void setMode(Mode mode);
  [[nodiscard]] Mode mode() const;
  void setNavigation(Navigation navigation);

  [[nodiscard]] SurfacePane* pane(std::size_t side) const { return panes_[side]; }
  [[nodiscard]] const std::array<VariantId, 2>& ids() const { return ids_; }
  /// What is shown; null: nothing yet.
  [[nodiscard]] const std::shared_ptr<const Compared>& shown() const { return shown_; }
  [[nodiscard]] bool busy() const { return comparison_->busy(); }

 protected:
  void hideEvent(QHideEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  [[nodiscard]] QWidget* modeRow();
  [[nodiscard]] QWidget* morphRow();
  void connectKeys();
  [[nodiscard]] SurfacePane* leading() const;
  void takeFirstView();
  void follow(Change change);
  void refresh();
  void take(const std::shared_ptr<const Compared>& compared);
  void showNames();
  void showContent();
  void showDifference();
  void enableMorph();
  void showMorph();
  void showProblems();
  static QToolButton* textButton(const char* objectName, const QString& text, const QString& tip,
                                 QWidget* parent);
  void flip();
  void play(bool on);
  [[nodiscard]] QString name(std::size_t side) const;
  [[nodiscard]] QString without() const;
  [[nodiscard]] double share() const;

  DocumentModel& model_;
  std::function<VariantsPage::View()> view_;
  Comparison* comparison_;
  std::array<VariantId, 2> ids_ = {0, 0};
  std::array<ComparedState, 2> states_;  // that were asked for last
  std::shared_ptr<const Compared> shown_;
  bool seen_ = false;  // the camera is where the result was seen from, or the person's

  QButtonGroup* modes_;
  std::array<SurfacePane*, 2> panes_ = {};
  std::array<PaneFrame*, 2> frames_ = {};
  QWidget* morph_ = nullptr;
  QToolButton* flip_ = nullptr;
  QToolButton* play_ = nullptr;
  QSlider* slider_ = nullptr;
  QVariantAnimation* animation_;
};

}  // namespace graftsman
