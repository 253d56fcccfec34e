#include "widgets/variants/suggestion_delegate.h"

#include <QAbstractItemView>
#include <QBuffer>
#include <QHelpEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "widgets/theme/contrast.h"
#include "widgets/theme/theme.h"
#include "widgets/variants/rounded_picture.h"
#include "widgets/variants/suggestions_model.h"

namespace graftsman {
namespace {

constexpr double kSuggestionCorner = 4;
constexpr int kSuggestionMargin = sizes::kGrid / 2;  // round the picture
constexpr int kLeastPicture = 112;
constexpr int kGreatestPicture = 176;
constexpr double kOutdatedOpacity = 0.45;
constexpr int kLines = 2;  // of what is different

QPainterPath roundedPath(const QRectF& rect) {
  return roundedRect(rect, kSuggestionCorner);
}

// The picture and what it is, as rich text.
QString pictureWithText(const QImage& picture, const QString& text) {
  QByteArray png;
  QBuffer buffer(&png);
  buffer.open(QIODevice::WriteOnly);
  picture.save(&buffer, "PNG");
  return QStringLiteral("<img src=\"data:image/png;base64,%1\"><br>%2")
      .arg(QString::fromLatin1(png.toBase64()), text.toHtmlEscaped().replace('\n', QStringLiteral("<br>")));
}

// The text in kLines lines, broken between words; what is too long is shortened.
QStringList linesOf(const QString& text, const QFontMetrics& metrics, int width) {
  QStringList lines = {QString()};
  const QStringList words = text.split(' ');
  for (const QString& word : words) {
    const QString longer = lines.back().isEmpty() ? word : lines.back() + ' ' + word;
    const bool fits = metrics.horizontalAdvance(longer) <= width;
    if (fits || lines.back().isEmpty() || lines.size() == kLines) {
      lines.back() = longer;
    } else {
      lines.append(word);
    }
  }
  for (QString& line : lines) {
    line = metrics.elidedText(line, Qt::ElideRight, width);
  }
  return lines;
}

}  // namespace

void SuggestionDelegate::fit(int width, int count) {
  const int pictureWidth =
      std::clamp(width / std::max(1, count) - 2 * kSuggestionMargin, kLeastPicture, kGreatestPicture);
  const QSize picture(pictureWidth, pictureWidth * 3 / 4);
  if (picture != picture_) {
    picture_ = picture;
    Q_EMIT sizeHintChanged({});
  }
}

QSize SuggestionDelegate::itemSize(const QFont& font) const {
  return {picture_.width() + 2 * kSuggestionMargin,
          picture_.height() + 3 * kSuggestionMargin + (kLines + 1) * QFontMetrics(font).height()};
}

QSize SuggestionDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const {
  return itemSize(option.font);
}

QRect SuggestionDelegate::pictureRect(const QRect& item) const {
  return {item.left() + kSuggestionMargin, item.top() + kSuggestionMargin, picture_.width(),
          picture_.height()};
}

void SuggestionDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index) const {
  const Theme theme = themeFor(option.palette);
  const bool taken = index.data(SuggestionsModel::Taken).toBool();
  const bool enabled = option.state.testFlag(QStyle::State_Enabled);
  const bool selected = enabled && option.state.testFlag(QStyle::State_Selected);
  const bool hovered = enabled && option.state.testFlag(QStyle::State_MouseOver);
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  if (selected || hovered) {
    QColor wash = theme.selected;
    wash.setAlphaF(selected ? 0.16F : 0.06F);
    painter->fillPath(roundedPath(QRectF(option.rect).adjusted(0.5, 0.5, -0.5, -0.5)), wash);
  }
  painter->setOpacity(enabled ? 1 : kOutdatedOpacity);
  const QRect rect = pictureRect(option.rect);
  const auto picture = index.data(SuggestionsModel::Picture).value<QImage>();
  if (picture.isNull()) {
    QLinearGradient gradient(rect.topLeft(), rect.bottomLeft());
    gradient.setColorAt(0, theme.backgroundTop);
    gradient.setColorAt(1, theme.backgroundBottom);
    painter->fillPath(roundedPath(rect), gradient);
  } else {
    painter->drawPixmap(rect.topLeft(), roundedPicture(picture, rect.size(), kSuggestionCorner,
                                                       painter->device()->devicePixelRatioF()));
  }
  if (taken || selected || option.state.testFlag(QStyle::State_HasFocus)) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(theme.selected, taken || selected ? 2 : 1));
    painter->drawPath(roundedPath(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5)));
  }

  // What was taken is bold, with a mark before it: not by weight or colour alone.
  const int height = QFontMetrics(option.font).height();
  QRect line(rect.left(), rect.bottom() + 1 + kSuggestionMargin, rect.width(), height);
  QFont font = option.font;
  font.setBold(taken);
  painter->setFont(font);
  painter->setPen(option.palette.color(QPalette::Active, QPalette::Text));
  const QString difference = (taken ? QStringLiteral("● ") : QString()) + index.data().toString();
  for (const QString& text : linesOf(difference, QFontMetrics(font), line.width())) {
    painter->drawText(line, Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextSingleLine, text);
    line.translate(0, height);
  }
  painter->setFont(option.font);
  const QColor base = option.palette.color(QPalette::Active, QPalette::Base);
  painter->setPen(legible(option.palette.color(QPalette::Active, QPalette::PlaceholderText), base));
  painter->drawText(
      line, Qt::AlignHCenter | Qt::AlignVCenter | Qt::TextSingleLine,
      QFontMetrics(option.font)
          .elidedText(index.data(SuggestionsModel::Measure).toString(), Qt::ElideRight, line.width()));
  painter->restore();
}

bool SuggestionDelegate::helpEvent(QHelpEvent* event, QAbstractItemView* view,
                                   const QStyleOptionViewItem& option, const QModelIndex& index) {
  const auto picture = index.data(SuggestionsModel::Picture).value<QImage>();
  if (event->type() != QEvent::ToolTip || picture.isNull()) {
    return QStyledItemDelegate::helpEvent(event, view, option, index);
  }
  QToolTip::showText(event->globalPos(), pictureWithText(picture, index.data(Qt::ToolTipRole).toString()),
                     view->viewport(), option.rect);
  return true;
}

}  // namespace graftsman

#include "moc_suggestion_delegate.cpp"  // NOLINT(bugprone-suspicious-include)
