#pragma once

#include <QSet>
#include <QWidget>

class QLabel;
class QTableView;

namespace graftsman {

class PairsModel;
class ProblemLine;

/// The table of pairs, with what comes next below it ("next: on the base"), or, of a selected pair, what is
/// wrong with it.
class PairsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PairsPanel(QWidget* parent = nullptr);

  [[nodiscard]] PairsModel* model() const { return model_; }
  [[nodiscard]] QTableView* view() const { return view_; }
  /// Selects these rows without selectionChanged(); scrolls to the first.
  void setSelected(const QSet<int>& rows);
  /// Scrolls to a row and shows, once, that it changed.
  void flashRow(int row);
  void setNext(const QString& text);

 Q_SIGNALS:
  /// The person selected other rows; also when rows that came or went gave the selected ones other numbers.
  void selectionChanged(const QSet<int>& rows);
  void removeWanted(const QSet<int>& rows);  // Delete

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void makeView();
  [[nodiscard]] QSet<int> selectedRows() const;
  void tellSelection();
  void showEmptyState();
  void showProblem();

  PairsModel* model_ = nullptr;
  QTableView* view_ = nullptr;
  QLabel* empty_ = nullptr;
  ProblemLine* next_ = nullptr;
  QSet<int> told_;
  bool changingRows_ = false;
};

}  // namespace graftsman
