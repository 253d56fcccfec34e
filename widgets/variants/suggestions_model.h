#pragma once

#include <QAbstractListModel>
#include <QImage>
#include <QString>
#include <vector>

namespace graftsman {

/// A suggestion as the strip shows it.
struct SuggestionRow {
  int id = 0;
  QString difference;  // from the present state: "Half, falloff 2"
  QString measure;     // what it is sorted by: "seam 12.3°"
};

/// Suggestions, a row each, with their pictures.
class SuggestionsModel : public QAbstractListModel {
  Q_OBJECT

 public:
  enum Role { Id = Qt::UserRole, Measure, Taken, Picture };

  explicit SuggestionsModel(QObject* parent = nullptr) : QAbstractListModel(parent) {}

  /// Replaces all rows; pictures go, but for those whose id is there again. Precondition: each id once.
  void setRows(std::vector<SuggestionRow> rows);
  void setPicture(int id, const QImage& picture);
  /// The one that the document is as at present; 0: none of them.
  void setTaken(int id);
  /// They are of a state that is past: dimmed, and none can be taken.
  void setOutdated(bool outdated);
  [[nodiscard]] bool outdated() const { return outdated_; }
  [[nodiscard]] int rowOf(int id) const;  // −1: not there

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

 private:
  void tellAll();

  std::vector<SuggestionRow> rows_;
  std::vector<QImage> pictures_;  // of each row
  int taken_ = 0;
  bool outdated_ = false;
};

}  // namespace graftsman
