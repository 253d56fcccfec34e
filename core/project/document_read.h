#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "core/io/fusion_json.h"
#include "core/project/document.h"

namespace graftsman {

/// Reads the fusions and variants of a project's document.json. What is malformed costs itself alone and is
/// told.
class DocumentReader {
 public:
  using json = fusion_json::json;
  /// The mesh that a fusion names for a side, {"result": id} being one without a mesh; null if it names none,
  /// or none that can be read, which is told.
  using Asset =
      std::function<std::shared_ptr<const MeshAsset>(Side, const json& fusion, const Progress& progress)>;
  /// Takes what was lost; `ofResult`: a result is not as it was saved.
  using Lose = std::function<void(Error, bool ofResult)>;

  DocumentReader(Asset asset, Lose lose) : asset_(std::move(asset)), lose_(std::move(lose)) {}

  /// At least one, where the list is not empty. Precondition: `list` is an array, not empty.
  [[nodiscard]] FusionList fusions(const json& list, const Progress& progress) const;
  [[nodiscard]] VariantList variants(const json& list) const;
  /// One fusion, without its number; its results have no names yet.
  [[nodiscard]] Fusion fusion(const json& object, const Progress& progress) const;

  /// The fusion that the object says is shown, or else the first. Precondition: fusions not empty.
  [[nodiscard]] static FusionId shown(const json& object, const FusionList& fusions);
  /// The value of a key that is a number from 1 on, or `fallback`.
  [[nodiscard]] static int id(const json& object, const char* key, int fallback);
  /// The value of a key that is a text, or `fallback`.
  [[nodiscard]] static std::string textOr(const json& object, const char* key, const std::string& fallback);

 private:
  void readInputs(const json& object, Fusion& read) const;
  void dropUnknownPoints(Fusion& fusion) const;
  void checkResults(FusionList& fusions) const;
  [[nodiscard]] std::shared_ptr<const Variant> variant(const json& record, int number) const;

  Asset asset_;
  Lose lose_;
};

}  // namespace graftsman
