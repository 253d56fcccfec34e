#pragma once

#include <QWidget>

class QComboBox;
class QLabel;
class QListView;
class QModelIndex;

namespace graftsman {

class ElidedLabel;
class SuggestionDelegate;
class SuggestionsModel;

/// Suggestions beside each other, as small pictures: above them by what they were chosen, and the box to
/// choose by something else. A click or Enter asks for one. Changes nothing itself.
class SuggestionStrip : public QWidget {
  Q_OBJECT

 public:
  explicit SuggestionStrip(QWidget* parent = nullptr);

  [[nodiscard]] SuggestionsModel* model() const { return model_; }
  [[nodiscard]] QListView* view() const { return view_; }

  /// The names of the orders; the first is chosen.
  void setOrders(const QStringList& orders);
  [[nodiscard]] int order() const;
  /// What is shown, or what is under way.
  void setSentence(const QString& sentence);
  /// Why there is none: instead of the pictures. Empty: the pictures.
  void setReason(const QString& reason);

 Q_SIGNALS:
  void takeWanted(int id);
  void orderChosen(int order);
  void closeWanted();
  /// Esc.
  void left();
  /// The palette changed.
  void paletteChanged();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  [[nodiscard]] QWidget* makeHeader();
  void makeView();
  void fit();
  void take(const QModelIndex& index);

  SuggestionsModel* model_;
  QListView* view_;
  SuggestionDelegate* delegate_;
  ElidedLabel* sentence_ = nullptr;
  QComboBox* orders_ = nullptr;
  QLabel* reason_ = nullptr;
};

}  // namespace graftsman
