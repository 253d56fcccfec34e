#include "widgets/variants/variant_delegate.h"

#include <QIcon>
#include <QImage>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "widgets/theme/contrast.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"
#include "widgets/variants/rounded_picture.h"
#include "widgets/variants/variants_model.h"

namespace graftsman {
namespace {

constexpr double kCorner = 6;
constexpr int kItemMargin = sizes::kGrid;  // round the picture
constexpr int kStar = 20;

QRect pictureRect(const QRect& item) {
  return {item.left() + (item.width() - VariantDelegate::kPicture.width()) / 2, item.top() + kItemMargin,
          VariantDelegate::kPicture.width(), VariantDelegate::kPicture.height()};
}

QRect nameRect(const QRect& item) {
  const QRect picture = pictureRect(item);
  const int top = picture.bottom() + 1 + sizes::kGrid / 2;
  return {picture.left(), top, picture.width(), item.bottom() + 1 - top - sizes::kGrid / 2};
}

QPainterPath rounded(const QRectF& rect) {
  return roundedRect(rect, kCorner);
}

void paintPicture(QPainter& painter, const QRect& rect, const QStyleOptionViewItem& option,
                  const QModelIndex& index) {
  const Theme theme = themeFor(option.palette);
  const auto picture = index.data(VariantsModel::Picture).value<QImage>();
  if (picture.isNull()) {
    QLinearGradient gradient(rect.topLeft(), rect.bottomLeft());
    gradient.setColorAt(0, theme.backgroundTop);
    gradient.setColorAt(1, theme.backgroundBottom);
    painter.fillPath(rounded(rect), gradient);
    if (index.data(VariantsModel::Problem).toString().isEmpty()) {
      painter.setPen(legible(option.palette.color(QPalette::PlaceholderText), theme.backgroundTop));
      painter.drawText(rect, Qt::AlignCenter, VariantDelegate::tr("No picture yet"));
    }
  } else {
    painter.drawPixmap(rect.topLeft(), roundedPicture(picture, VariantDelegate::kPicture, kCorner,
                                                      painter.device()->devicePixelRatioF()));
  }
}

void paintStar(QPainter& painter, const QRect& item, const QStyleOptionViewItem& option, bool starred) {
  if (!starred && !option.state.testFlag(QStyle::State_MouseOver)) {
    return;
  }
  const QRect rect = VariantDelegate::starRect(item);
  QColor disk = option.palette.color(QPalette::Base);
  disk.setAlphaF(starred ? 0.88F : 0.6F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(disk);
  painter.drawEllipse(QRectF(rect).adjusted(-3, -3, 3, 3));
  icon(starred ? QStringLiteral("star-full") : QStringLiteral("star"), option.palette.color(QPalette::Text))
      .paint(&painter, rect.adjusted(2, 2, -2, -2));
}

void paintProblem(QPainter& painter, const QRect& item, const Theme& theme, const QPalette& palette) {
  const QRect picture = pictureRect(item);
  const QRect rect(picture.left() + sizes::kGrid, picture.top() + sizes::kGrid, kStar, kStar);
  QColor disk = palette.color(QPalette::Base);
  disk.setAlphaF(0.88F);
  painter.setPen(Qt::NoPen);
  painter.setBrush(disk);
  painter.drawEllipse(QRectF(rect).adjusted(-3, -3, 3, 3));
  icon(QStringLiteral("problem"), theme.problem).paint(&painter, rect.adjusted(1, 1, -1, -1));
}

}  // namespace

QRect VariantDelegate::starRect(const QRect& item) {
  const QRect picture = pictureRect(item);
  return {picture.right() + 1 - kStar - sizes::kGrid, picture.top() + sizes::kGrid, kStar, kStar};
}

void VariantDelegate::setItemWidth(int width) {
  if (width != itemWidth_) {
    itemWidth_ = std::max(width, kLeastWidth);
    Q_EMIT sizeHintChanged({});
  }
}

QSize VariantDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const {
  return {itemWidth_,
          kItemMargin + kPicture.height() + sizes::kGrid + option.fontMetrics.height() + sizes::kGrid / 2};
}

void VariantDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                            const QModelIndex& index) const {
  const Theme theme = themeFor(option.palette);
  const bool selected = option.state.testFlag(QStyle::State_Selected);
  const bool hovered = option.state.testFlag(QStyle::State_MouseOver);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  if (selected || hovered) {
    QColor wash = theme.selected;
    wash.setAlphaF(selected ? 0.16F : 0.06F);
    const QRectF picture = pictureRect(option.rect);
    painter->fillPath(rounded({picture.left() - kItemMargin + 1, option.rect.top() + 1.0,
                               picture.width() + 2 * kItemMargin - 2, option.rect.height() - 2.0}),
                      wash);
  }
  paintPicture(*painter, pictureRect(option.rect), option, index);
  if (selected || option.state.testFlag(QStyle::State_HasFocus)) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(theme.selected, selected ? 2 : 1));
    painter->drawPath(rounded(QRectF(pictureRect(option.rect)).adjusted(0.5, 0.5, -0.5, -0.5)));
  }
  paintStar(*painter, option.rect, option, index.data(VariantsModel::Starred).toBool());
  if (!index.data(VariantsModel::Problem).toString().isEmpty()) {
    paintProblem(*painter, option.rect, theme, option.palette);
  }

  // The name of the present state is bold, with a mark before it: not by weight alone.
  QFont font = option.font;
  const bool present = index.data(VariantsModel::Present).toBool();
  font.setBold(present);
  painter->setFont(font);
  painter->setPen(option.palette.color(QPalette::Text));
  const QRect line = nameRect(option.rect);
  const QString name = (present ? QStringLiteral("● ") : QString()) + index.data().toString();
  painter->drawText(line, Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextSingleLine,
                    QFontMetrics(font).elidedText(name, Qt::ElideRight, line.width()));
  painter->restore();
}

QWidget* VariantDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& /*option*/,
                                       const QModelIndex& /*index*/) const {
  auto* editor = new QLineEdit(parent);
  editor->setObjectName(QStringLiteral("variantNameEditor"));
  editor->setAccessibleName(tr("Name of the variant"));
  editor->setAlignment(Qt::AlignCenter);
  return editor;
}

void VariantDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                           const QModelIndex& /*index*/) const {
  editor->setGeometry(nameRect(option.rect).adjusted(0, -3, 0, 3));
}

bool VariantDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
                                  const QStyleOptionViewItem& option, const QModelIndex& index) {
  if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease) {
    const auto& mouse = static_cast<const QMouseEvent&>(*event);
    if (mouse.button() == Qt::LeftButton &&
        starRect(option.rect).adjusted(-4, -4, 4, 4).contains(mouse.position().toPoint())) {
      if (event->type() == QEvent::MouseButtonRelease) {
        Q_EMIT starClicked(index);
      }
      return true;
    }
  }
  if (event->type() == QEvent::MouseButtonDblClick &&
      nameRect(option.rect).contains(static_cast<QMouseEvent*>(event)->position().toPoint())) {
    Q_EMIT nameDoubleClicked(index);
    return true;
  }
  return QStyledItemDelegate::editorEvent(event, model, option, index);
}

}  // namespace graftsman

#include "moc_variant_delegate.cpp"  // NOLINT(bugprone-suspicious-include)
