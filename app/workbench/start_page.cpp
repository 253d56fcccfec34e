#include "app/workbench/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/workbench/samples.h"
#include "widgets/theme/icon.h"
#include "widgets/theme/theme.h"

namespace graftsman {
namespace {

constexpr QSize kPicture(232, 152);
constexpr int kColumns = 3;

QLabel* heading(const QString& text, double scale) {
  auto* label = new QLabel(text);
  QFont font = label->font();
  font.setPointSizeF(font.pointSizeF() * scale);
  font.setBold(true);
  label->setFont(font);
  return label;
}

QPushButton* wideButton(const QString& name, const QString& text, const QString& iconName,
                        const QString& tip) {
  auto* button = new QPushButton(icon(iconName), text);
  button->setObjectName(name);
  button->setToolTip(tip);
  button->setMinimumHeight(4 * sizes::kGrid);
  return button;
}

void clear(QLayout* layout) {
  while (QLayoutItem* item = layout->takeAt(0)) {
    delete item->widget();
    delete item;
  }
}

}  // namespace

StartPage::StartPage(QWidget* parent) : QWidget(parent) {
  setObjectName("startPage");
  auto* page = new QWidget;
  auto* columns = new QHBoxLayout(page);
  columns->setContentsMargins(5 * sizes::kGrid, 4 * sizes::kGrid, 5 * sizes::kGrid, 4 * sizes::kGrid);
  columns->setSpacing(5 * sizes::kGrid);

  auto* left = new QVBoxLayout;
  left->setSpacing(sizes::kGrid);
  left->addWidget(heading(tr("Graftsman"), 2));
  left->addWidget(
      new QLabel(tr("Cut a region out of one mesh, graft it onto another, and shape the change\n"
                    "from the one into the other with a curve.")));
  left->addSpacing(2 * sizes::kGrid);
  left->addWidget(heading(tr("Try a sample"), 1.2));
  left->addWidget(makeSamples());
  left->addStretch();
  columns->addLayout(left, 3);

  auto* right = new QVBoxLayout;
  right->setSpacing(sizes::kGrid);
  right->addWidget(heading(tr("Begin"), 1.2));
  QPushButton* part = wideButton("startLoadPart", tr("Load part"), "load-part",
                                 tr("Read the mesh that is pasted (Ctrl+Shift+P)"));
  QPushButton* base = wideButton("startLoadBase", tr("Load base"), "load-base",
                                 tr("Read the mesh that receives the part (Ctrl+Shift+B)"));
  QPushButton* open =
      wideButton("startOpen", tr("Open a project"), "open", tr("Open a project or a scenario (Ctrl+O)"));
  connect(part, &QPushButton::clicked, this, [this] { Q_EMIT loadWanted(Side::Part); });
  connect(base, &QPushButton::clicked, this, [this] { Q_EMIT loadWanted(Side::Base); });
  connect(open, &QPushButton::clicked, this, &StartPage::openDialogWanted);
  for (QPushButton* button : {part, base, open}) {
    right->addWidget(button);
  }
  right->addSpacing(2 * sizes::kGrid);
  right->addWidget(makeSteps());
  right->addSpacing(2 * sizes::kGrid);
  right->addWidget(heading(tr("Recent projects"), 1.2));
  recent_ = new QVBoxLayout;
  right->addLayout(recent_);
  right->addStretch();
  columns->addLayout(right, 1);

  auto* scroll = new QScrollArea;
  scroll->setObjectName("startScroll");
  scroll->setAccessibleName(tr("Start page"));
  scroll->setWidget(page);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
}

QWidget* StartPage::makeSamples() {
  auto* widget = new QWidget;
  auto* grid = new QGridLayout(widget);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2 * sizes::kGrid);
  int number = 0;
  for (const Sample& sample : findSamples()) {
    auto* button = new QToolButton;
    button->setObjectName(QString("sample%1").arg(number));
    button->setAccessibleName(sample.title);
    button->setToolTip(tr("Open “%1” as a new project").arg(sample.title));
    button->setText(sample.title);
    button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
    button->setIcon(QIcon(sample.picture));
    button->setIconSize(kPicture);
    button->setAutoRaise(true);
    connect(button, &QToolButton::clicked, this, [this, path = sample.path] { Q_EMIT openWanted(path); });
    grid->addWidget(button, number / kColumns, number % kColumns);
    ++number;
  }
  grid->setColumnStretch(kColumns, 1);
  return widget;
}

QWidget* StartPage::makeSteps() {
  auto* steps =
      new QLabel(tr("<ol style='margin-left:-14px'>"
                    "<li>Load a part and a base.</li>"
                    "<li>Click pairs of points round the two regions, counter-clockwise, and close the "
                    "loop.</li>"
                    "<li>Drag the fusion curve: the result follows.</li></ol>"));
  steps->setObjectName("steps");
  steps->setWordWrap(true);
  return steps;
}

void StartPage::setRecent(const QStringList& paths) {
  clear(recent_);
  for (const QString& path : paths) {
    if (!QFileInfo::exists(path)) {
      continue;
    }
    auto* button = new QPushButton(QFileInfo(path).completeBaseName());
    button->setFlat(true);
    button->setStyleSheet("text-align: left");
    button->setToolTip(QDir::toNativeSeparators(path));
    button->setObjectName("recent");
    connect(button, &QPushButton::clicked, this, [this, path] { Q_EMIT openWanted(path); });
    recent_->addWidget(button);
  }
  if (recent_->count() == 0) {
    auto* none = new QLabel(tr("None yet"));
    recent_->addWidget(none);
  }
}

}  // namespace graftsman
