#pragma once

#include <QStyledItemDelegate>

namespace graftsman {

/// Draws a variant: its picture with rounded corners, the star in its corner, the name below, and a quiet
/// frame round those that are selected. A click on the star's corner asks for the star, a double click on the
/// name for another one.
class VariantDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  explicit VariantDelegate(QObject* parent = nullptr) : QStyledItemDelegate(parent) {}

  /// Of the picture, in device-independent pixels, 4 : 3.
  static constexpr QSize kPicture{192, 144};
  /// Of an item: the picture with a margin.
  static constexpr int kLeastWidth = 208;

  /// The width of every item, at least kLeastWidth; the picture stands in its middle.
  void setItemWidth(int width);

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                        const QModelIndex& index) const override;
  void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const override;
  /// Where the star is, in an item of this rectangle.
  [[nodiscard]] static QRect starRect(const QRect& item);

 Q_SIGNALS:
  void starClicked(const QModelIndex& index);
  void nameDoubleClicked(const QModelIndex& index);

 protected:
  bool editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                   const QModelIndex& index) override;

 private:
  int itemWidth_ = kLeastWidth;
};

}  // namespace graftsman
