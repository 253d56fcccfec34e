#pragma once

#include <QWidget>
#include <vector>

class QAction;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QListView;
class QToolButton;

namespace graftsman {

class ElidedLabel;
class VariantDelegate;
class VariantsFilter;
class VariantsModel;

/// The variants as pictures: above them what is shown and in which order, below them what can be done with
/// those that are selected. Changes nothing itself: says what the person wants.
class VariantsGallery : public QWidget {
  Q_OBJECT

 public:
  explicit VariantsGallery(QWidget* parent = nullptr);

  [[nodiscard]] VariantsModel* model() const { return model_; }
  [[nodiscard]] VariantsFilter* filter() const { return filter_; }
  [[nodiscard]] QListView* view() const { return view_; }

  /// Ids of the selected ones that are shown; the one with the keyboard's mark, which was clicked last, is
  /// the last, the others are in the order of the gallery.
  [[nodiscard]] std::vector<int> selected() const;
  void select(const std::vector<int>& ids);
  /// Begins to edit the name of the only selected variant; of several, nothing.
  void rename();

  /// A button for what can be done with the selected variants: with any of them, or with several alone.
  void addAction(QAction* action, bool withSeveral);
  /// What is under way ("drawing 3 pictures"); empty: nothing.
  void setActivity(const QString& text);
  /// How to keep the first variant.
  void setEmptyText(const QString& text);

 Q_SIGNALS:
  void selectionChanged();
  void noteWanted(int id, const QString& note);
  void starWanted(const std::vector<int>& ids, bool starred);
  void removeWanted(const std::vector<int>& ids);
  void applyWanted(int id);
  void contextMenuWanted(const QPoint& globalPosition);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeView();
  [[nodiscard]] QWidget* makeHeader();
  [[nodiscard]] QWidget* makeFooter();
  void connectView();
  bool keyPressed(QEvent* event);
  void toggleStars(const std::vector<int>& ids);
  void fitColumns();
  void tellNote();
  void showSelection();
  void showCount();

  VariantsModel* model_;
  VariantsFilter* filter_;
  QListView* view_;
  VariantDelegate* delegate_;
  QLabel* count_ = nullptr;
  QLabel* empty_ = nullptr;
  QLineEdit* words_ = nullptr;
  QToolButton* starred_ = nullptr;
  ElidedLabel* chosen_ = nullptr;
  QLineEdit* note_ = nullptr;
  QHBoxLayout* footer_ = nullptr;
  std::vector<QWidget*> forSeveral_;
  QString activity_;
  QString emptyText_;
  int noted_ = 0;  // the variant whose note is in the line; 0: none
};

}  // namespace graftsman
