#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "widgets/variants/variant_delegate.h"
#include "widgets/variants/variants_filter.h"
#include "widgets/variants/variants_gallery.h"
#include "widgets/variants/variants_model.h"

using namespace graftsman;

namespace {

using Ids = std::vector<int>;

VariantRow variant(int id, const QString& name = {}, bool starred = false, const QString& note = {}) {
  return {id, name.isEmpty() ? QString("Variant %1").arg(id) : name, note, starred, false};
}

std::vector<VariantRow> variants(int count) {
  std::vector<VariantRow> rows;
  for (int i = 1; i <= count; ++i) {
    rows.push_back(variant(i));
  }
  return rows;
}

QImage picture(const QColor& colour) {
  QImage image(384, 288, QImage::Format_RGB32);
  image.fill(colour);
  return image;
}

Ids idsOf(const QAbstractItemModel& model) {
  Ids ids;
  for (int row = 0; row < model.rowCount(); ++row) {
    ids.push_back(model.index(row, 0).data(VariantsModel::Id).toInt());
  }
  return ids;
}

struct ShownGallery {
  VariantsGallery gallery;

  explicit ShownGallery(std::vector<VariantRow> rows) {
    gallery.model()->setRows(std::move(rows));
    gallery.resize(900, 600);
    gallery.show();
    gallery.activateWindow();
    gallery.view()->setFocus();
  }
  [[nodiscard]] bool ready() {
    return QTest::qWaitForWindowActive(&gallery) &&
           QTest::qWaitFor([&] { return gallery.view()->hasFocus(); });
  }
  [[nodiscard]] QRect rect(int id) const {
    const QModelIndex index =
        gallery.filter()->mapFromSource(gallery.model()->index(gallery.model()->rowOf(id)));
    return gallery.view()->visualRect(index);
  }
  void click(int id, Qt::KeyboardModifiers modifiers = {}) const {
    QTest::mouseClick(gallery.view()->viewport(), Qt::LeftButton, modifiers, rect(id).center());
  }
  [[nodiscard]] Ids shown() const { return idsOf(*gallery.filter()); }
};

}  // namespace

class VariantsGalleryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void anyRowsAfterAnyOthersAreShownRightAndKeepTheirPictures() {
    VariantsModel model;
    const QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QSignalSpy reset(&model, &QAbstractItemModel::modelReset);
    QRandomGenerator random(5);
    for (int step = 0; step < 200; ++step) {
      std::vector<VariantRow> rows;
      for (int id = 1; id <= 12; ++id) {
        if (random.bounded(3) != 0) {
          rows.push_back(variant(id, QString("name %1").arg(random.bounded(3)), random.bounded(2) == 0));
        }
      }
      if (!rows.empty()) {
        std::swap(rows.front(), rows[random.bounded(static_cast<quint32>(rows.size()))]);
      }
      QHash<int, qint64> before;
      for (int row = 0; row < model.rowCount(); ++row) {
        before[model.rows()[static_cast<std::size_t>(row)].id] =
            model.index(row).data(VariantsModel::Picture).value<QImage>().cacheKey();
      }
      model.setRows(rows);
      QCOMPARE(model.rows(), rows);
      for (int row = 0; row < model.rowCount(); ++row) {
        const int id = rows[static_cast<std::size_t>(row)].id;
        if (before.contains(id)) {
          QCOMPARE(model.index(row).data(VariantsModel::Picture).value<QImage>().cacheKey(), before[id]);
        }
        model.setPicture(id, picture(Qt::red), {});
      }
    }
    QCOMPARE(reset.count(), 0);
  }

  void equalRowsTellNothingAndAChangedOneItself() {
    VariantsModel model;
    model.setRows(variants(5));
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy removed(&model, &QAbstractItemModel::rowsRemoved);
    model.setRows(variants(5));
    QCOMPARE(changed.count(), 0);
    auto rows = variants(5);
    rows[3].starred = true;
    model.setRows(rows);
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed.first().first().value<QModelIndex>().row(), 3);
    QCOMPARE(removed.count(), 0);
  }

  void aRenameIsAskedForAndNotMade() {
    VariantsModel model;
    model.setRows(variants(2));
    QSignalSpy wanted(&model, &VariantsModel::renameWanted);
    QVERIFY(model.setData(model.index(1), "  Long   nose ", Qt::EditRole));
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.first().at(0).toInt(), 2);
    QCOMPARE(wanted.first().at(1).toString(), "Long nose");
    QCOMPARE(model.index(1).data().toString(), "Variant 2");
    QVERIFY(!model.setData(model.index(1), "  ", Qt::EditRole));
    QVERIFY(model.setData(model.index(1), "Variant 2", Qt::EditRole));
    QCOMPARE(wanted.count(), 1);
  }

  void ordersAndFilters() {
    VariantsModel model;
    VariantsFilter filter;
    const QAbstractItemModelTester tester(&filter, QAbstractItemModelTester::FailureReportingMode::QtTest);
    filter.setSourceModel(&model);
    model.setRows({variant(1, "nose 10"), variant(2, "Nose 2", true),
                   variant(3, "horn", false, "short, a nose"), variant(4, "beak", true)});
    QCOMPARE(idsOf(filter), (Ids{1, 2, 3, 4}));
    filter.setOrder(VariantsFilter::Order::Newest);
    QCOMPARE(idsOf(filter), (Ids{4, 3, 2, 1}));
    filter.setOrder(VariantsFilter::Order::Name);
    QCOMPARE(idsOf(filter), (Ids{4, 3, 2, 1}));
    filter.setOrder(VariantsFilter::Order::Star);
    QCOMPARE(idsOf(filter), (Ids{2, 4, 1, 3}));
    filter.setOrder(VariantsFilter::Order::Number);
    filter.setWords("NOSE");
    QCOMPARE(idsOf(filter), (Ids{1, 2, 3}));
    filter.setWords("nose short");
    QCOMPARE(idsOf(filter), (Ids{3}));
    filter.setWords({});
    filter.setStarredOnly(true);
    QCOMPARE(idsOf(filter), (Ids{2, 4}));
    // A star that goes takes the variant out of what is shown.
    auto rows = model.rows();
    rows[1].starred = false;
    model.setRows(rows);
    QCOMPARE(idsOf(filter), (Ids{4}));
  }

  void keysAskForWhatTheyMean() {
    ShownGallery shown(variants(6));
    QVERIFY(shown.ready());
    QSignalSpy removed(&shown.gallery, &VariantsGallery::removeWanted);
    QSignalSpy starred(&shown.gallery, &VariantsGallery::starWanted);
    QSignalSpy applied(&shown.gallery, &VariantsGallery::applyWanted);
    QTest::keyClick(shown.gallery.view(), Qt::Key_Delete);
    QCOMPARE(removed.count(), 0);
    shown.click(2);
    shown.click(5, Qt::ControlModifier);
    QCOMPARE(shown.gallery.selected(), (Ids{2, 5}));
    QTest::keyClick(shown.gallery.view(), Qt::Key_Delete);
    QCOMPARE(removed.last().first().value<Ids>(), (Ids{2, 5}));
    QTest::keyClick(shown.gallery.view(), Qt::Key_S);
    QCOMPARE(starred.last().at(0).value<Ids>(), (Ids{2, 5}));
    QCOMPARE(starred.last().at(1).toBool(), true);
    shown.click(3);
    QTest::keyClick(shown.gallery.view(), Qt::Key_Return);
    QCOMPARE(applied.last().first().toInt(), 3);
  }

  void theOneClickedLastIsTheLastOfTheSelected() {
    ShownGallery shown(variants(6));
    QVERIFY(shown.ready());
    shown.click(5);
    shown.click(2, Qt::ControlModifier);
    QCOMPARE(shown.gallery.selected(), (Ids{5, 2}));
  }

  void aDoubleClickOnThePictureAppliesAndOnTheNameRenames() {
    ShownGallery shown(variants(3));
    QVERIFY(shown.ready());
    QSignalSpy applied(&shown.gallery, &VariantsGallery::applyWanted);
    QWidget* viewport = shown.gallery.view()->viewport();
    const QRect rect = shown.rect(2);
    const auto doubleClick = [&](const QPoint& at) {
      QTest::mouseClick(viewport, Qt::LeftButton, {}, at);
      QTest::mouseDClick(viewport, Qt::LeftButton, {}, at);
    };
    doubleClick(rect.center());
    QCOMPARE(applied.count(), 1);
    QCOMPARE(applied.first().first().toInt(), 2);
    QVERIFY(!shown.gallery.findChild<QLineEdit*>("variantNameEditor"));
    doubleClick(QPoint(rect.center().x(), rect.bottom() - 10));
    QCOMPARE(applied.count(), 1);
    auto* editor = shown.gallery.findChild<QLineEdit*>("variantNameEditor");
    QVERIFY(editor);
    QCOMPARE(editor->text(), "Variant 2");
    QSignalSpy renamed(shown.gallery.model(), &VariantsModel::renameWanted);
    QTest::keyClicks(editor, "Sledge");
    QTest::keyClick(editor, Qt::Key_Return);
    QTRY_COMPARE(renamed.count(), 1);
    QCOMPARE(renamed.first().at(1).toString(), "Sledge");
    QCOMPARE(applied.count(), 1);
  }

  void aClickOnTheStarStarsThatVariantAlone() {
    ShownGallery shown(variants(4));
    QVERIFY(shown.ready());
    QSignalSpy starred(&shown.gallery, &VariantsGallery::starWanted);
    QTest::mouseClick(shown.gallery.view()->viewport(), Qt::LeftButton, {},
                      VariantDelegate::starRect(shown.rect(3)).center());
    QCOMPARE(starred.count(), 1);
    QCOMPARE(starred.first().at(0).value<Ids>(), (Ids{3}));
  }

  void theNoteOfTheSelectedVariantIsEditedBelow() {
    ShownGallery shown({variant(1, "a", false, "first"), variant(2, "b")});
    QVERIFY(shown.ready());
    auto* note = shown.gallery.findChild<QLineEdit*>("variantNote");
    QVERIFY(!note->isEnabled());
    shown.click(1);
    QCOMPARE(note->text(), "first");
    shown.click(2);
    QCOMPARE(note->text(), QString());
    QSignalSpy noted(&shown.gallery, &VariantsGallery::noteWanted);
    note->setFocus();
    QTest::keyClicks(note, "too long");
    // A click elsewhere keeps it.
    shown.click(1);
    QCOMPARE(noted.count(), 1);
    QCOMPARE(noted.first().at(0).toInt(), 2);
    QCOMPARE(noted.first().at(1).toString(), "too long");
    QCOMPARE(note->text(), "first");
  }

  void selectionSurvivesNewRows() {
    ShownGallery shown(variants(5));
    QVERIFY(shown.ready());
    shown.gallery.select({2, 4});
    auto rows = variants(5);
    rows.erase(rows.begin() + 2);
    rows.push_back(variant(9));
    shown.gallery.model()->setRows(rows);
    QCOMPARE(shown.gallery.selected(), (Ids{2, 4}));
  }

  void theEmptyGallerySaysHowToBegin() {
    ShownGallery shown({});
    QVERIFY(shown.ready());
    auto* empty = shown.gallery.findChild<QLabel*>("variantsEmpty");
    shown.gallery.setEmptyText("Keep one");
    QVERIFY(empty->isVisible());
    QCOMPARE(empty->text(), "Keep one");
    shown.gallery.model()->setRows(variants(2));
    QVERIFY(!empty->isVisible());
    auto* words = shown.gallery.findChild<QLineEdit*>("variantsWords");
    QTest::keyClicks(words, "zebra");
    QVERIFY(empty->isVisible());
    QVERIFY(empty->text() != "Keep one");
    QCOMPARE(shown.gallery.findChild<QLabel*>("variantsCount")->text(), "0 of 2");
  }

  void starAndOrderAreChosenAboveThePictures() {
    ShownGallery shown({variant(1), variant(2, {}, true), variant(3, {}, true)});
    QVERIFY(shown.ready());
    shown.gallery.findChild<QComboBox*>("variantsOrder")->setCurrentIndex(1);
    QCOMPARE(shown.shown(), (Ids{3, 2, 1}));
    QTest::mouseClick(shown.gallery.findChild<QToolButton*>("variantsStarred"), Qt::LeftButton);
    QCOMPARE(shown.shown(), (Ids{3, 2}));
  }

  void thePictureIsDrawnInItsPlace() {
    ShownGallery shown(variants(2));
    QVERIFY(shown.ready());
    shown.gallery.model()->setPicture(1, picture(QColor("#3060A0")), {});
    const QImage seen = shown.gallery.view()->viewport()->grab().toImage();
    QCOMPARE(seen.pixelColor(shown.rect(1).center()), QColor("#3060A0"));
    QVERIFY(seen.pixelColor(shown.rect(2).center()) != QColor("#3060A0"));
  }
};

QTEST_MAIN(VariantsGalleryTest)
#include "variants_gallery_test.moc"
