#pragma once

#include <QAbstractListModel>
#include <QImage>
#include <QString>
#include <vector>

namespace graftsman {

/// A variant as the gallery shows it.
struct VariantRow {
  int id = 0;
  QString name;
  QString note;
  bool starred = false;
  bool present = false;  // its fusions are as those of the document are now
  friend bool operator==(const VariantRow&, const VariantRow&) = default;
};

/// The variants of a document, a row each, with their pictures. A rename is only asked for: whoever owns the
/// document answers with new rows.
class VariantsModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role { Id = Qt::UserRole, Name, Note, Starred, Present, Picture, Problem };

  explicit VariantsModel(QObject* parent = nullptr) : QAbstractListModel(parent) {}

  /// Replaces the rows with as few signals as the difference needs: selections survive. Precondition: each
  /// id once. A picture goes when its row does.
  void setRows(std::vector<VariantRow> rows);
  [[nodiscard]] const std::vector<VariantRow>& rows() const { return rows_; }
  [[nodiscard]] int rowOf(int id) const;  // −1: not there

  /// The picture of a variant, and why it has no result (empty: it has one).
  void setPicture(int id, const QImage& picture, const QString& problem);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

 Q_SIGNALS:
  void renameWanted(int id, const QString& name);

 private:
  struct Shown {
    QImage picture;
    QString problem;
  };

  [[nodiscard]] QString toolTip(std::size_t row) const;

  std::vector<VariantRow> rows_;
  std::vector<Shown> shown_;  // of each row
};

}  // namespace graftsman
