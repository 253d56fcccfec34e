#pragma once

#include <QSet>
#include <QWidget>

class QLabel;
class QTableView;

namespace graftsman {

class PairsModel;

/// The table of pairs, with what comes next below it ("next: on the base").
class PairsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PairsPanel(QWidget* parent = nullptr);

  [[nodiscard]] PairsModel* model() const { return model_; }
  [[nodiscard]] QTableView* view() const { return view_; }
  /// Selects these rows without selectionChanged(); scrolls to the first.
  void setSelected(const QSet<int>& rows);
  void setNext(const QString& text);

 Q_SIGNALS:
  void selectionChanged(const QSet<int>& rows);
  void removeWanted(const QSet<int>& rows);  // Delete

 private:
  PairsModel* model_ = nullptr;
  QTableView* view_ = nullptr;
  QLabel* next_ = nullptr;
};

}  // namespace graftsman
