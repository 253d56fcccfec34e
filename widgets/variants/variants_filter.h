#pragma once

#include <QCollator>
#include <QSortFilterProxyModel>

namespace graftsman {

/// The variants that are shown, in the order in which they are: those with a star alone or all, those that
/// have the words in name or note.
class VariantsFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  enum class Order { Number, Newest, Name, Star };

  explicit VariantsFilter(QObject* parent = nullptr);

  void setOrder(Order order);
  void setStarredOnly(bool only);
  /// Each word must be there, in any case of letters. Empty: all.
  void setWords(const QString& words);

 protected:
  [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  [[nodiscard]] bool lessThan(const QModelIndex& a, const QModelIndex& b) const override;

 private:
  Order order_ = Order::Number;
  bool starredOnly_ = false;
  QStringList words_;
  QCollator collator_;
};

}  // namespace graftsman
