#pragma once

#include <QListView>

#include "app/workbench/variant_pictures.h"
#include "app/workbench/variants_page.h"
#include "tests/support/workbench.h"
#include "widgets/variants/variants_filter.h"
#include "widgets/variants/variants_gallery.h"
#include "widgets/variants/variants_model.h"

/// The window's gallery under a test's hands.
namespace graftsman {

struct GalleryHands {
  const Workbench& bench;

  [[nodiscard]] VariantsGallery& gallery() const { return *bench.window->variantsPage().gallery(); }
  [[nodiscard]] QListView* view() const { return gallery().view(); }
  [[nodiscard]] const VariantList& variants() const { return bench.window->model().document().variants; }

  /// The names that are shown, in their order.
  [[nodiscard]] QStringList shown() const {
    QStringList names;
    for (int row = 0; row < view()->model()->rowCount(); ++row) {
      names.append(view()->model()->index(row, 0).data().toString());
    }
    return names;
  }
  /// Where the variant of that name is seen.
  [[nodiscard]] QRect rect(const QString& name) const {
    const int row = static_cast<int>(shown().indexOf(name));
    return view()->visualRect(view()->model()->index(row, 0));
  }
  void click(const QString& name, Qt::KeyboardModifiers modifiers = {}) const {
    QTest::mouseClick(view()->viewport(), Qt::LeftButton, modifiers, rect(name).center());
  }
  void key(int key, Qt::KeyboardModifiers modifiers = {}) const {
    QTest::keyClick(view(), static_cast<Qt::Key>(key), modifiers);
  }
  [[nodiscard]] QImage picture(const QString& name) const {
    return view()
        ->model()
        ->index(static_cast<int>(shown().indexOf(name)), 0)
        .data(VariantsModel::Picture)
        .value<QImage>();
  }
  /// True once every variant has its picture.
  [[nodiscard]] bool drawn() const {
    return QTest::qWaitFor(
        [this] {
          if (bench.window->variantsPage().pictures()->missing() > 0) {
            return false;
          }
          for (const QString& name : shown()) {
            if (picture(name).isNull()) {
              return false;
            }
          }
          return true;
        },
        kPatienceMs);
  }
};

}  // namespace graftsman
