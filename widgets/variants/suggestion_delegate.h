#pragma once

#include <QStyledItemDelegate>

namespace graftsman {

/// Draws a suggestion: its picture, below it what is different, and the measure. The pointer over it brings a
/// tooltip with the picture as large as it was drawn.
class SuggestionDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  explicit SuggestionDelegate(QObject* parent = nullptr) : QStyledItemDelegate(parent) {}

  /// So that `count` items fill this width, as far as pictures stay between a least and a greatest size.
  void fit(int width, int count);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize itemSize(const QFont& font) const;

 protected:
  bool helpEvent(QHelpEvent* event, QAbstractItemView* view, const QStyleOptionViewItem& option,
                 const QModelIndex& index) override;

 private:
  [[nodiscard]] QRect pictureRect(const QRect& item) const;

  QSize picture_{112, 84};  // 4 : 3
};

}  // namespace graftsman
