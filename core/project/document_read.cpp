#include "core/project/document_read.h"

#include <algorithm>
#include <limits>
#include <string>

#include "core/io/printable.h"
#include "core/project/document_edits.h"

namespace graftsman {

using namespace fusion_json;

namespace {

constexpr std::size_t kLongestList = 400;  // bytes of pairs' numbers in a message

}  // namespace

int DocumentReader::id(const json& object, const char* key, int fallback) {
  const json* value = find(object, key);
  const bool given = value != nullptr && value->is_number_integer() && *value > 0 &&
                     *value <= std::numeric_limits<int>::max();
  return given ? value->get<int>() : fallback;
}

std::string DocumentReader::textOr(const json& object, const char* key, const std::string& fallback) {
  const json* value = find(object, key);
  return value != nullptr && value->is_string() ? value->get<std::string>() : fallback;
}

FusionId DocumentReader::shown(const json& object, const FusionList& fusions) {
  const FusionId wanted = id(object, "shown", fusions.front()->id);
  return graftsman::find(fusions, wanted) != nullptr ? wanted : fusions.front()->id;
}

FusionList DocumentReader::fusions(const json& list, const Progress& progress) const {
  FusionList read;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto share = [&](std::size_t done) {
      return static_cast<double>(done) / static_cast<double>(list.size());
    };
    Fusion made = fusion(list[i], progress.span(share(i), share(i + 1)));
    made.id = list[i].is_object() ? id(list[i], "id", static_cast<int>(i) + 1) : static_cast<int>(i) + 1;
    if (graftsman::find(read, made.id) != nullptr) {
      lose_({ErrorCode::FileMalformed, "Two of the project's fusions have the number " +
                                           std::to_string(made.id) + "; the second was left out."},
            true);
      continue;
    }
    read.push_back(std::make_shared<const Fusion>(std::move(made)));
  }
  checkResults(read);
  return read;
}

Fusion DocumentReader::fusion(const json& object, const Progress& progress) const {
  Fusion read;
  if (!object.is_object()) {
    lose_({ErrorCode::FileMalformed,
           "The project's fusion cannot be understood, so it starts anew. Load the meshes again."},
          true);
    return read;
  }
  read.name = textOr(object, "name", "");
  setAsset(read, Side::Part, asset_(Side::Part, object, progress.span(0, 0.5)));
  setAsset(read, Side::Base, asset_(Side::Base, object, progress.span(0.5, 1)));
  readInputs(object, read);
  return read;
}

// Results that fusions are made of: given their names, or left out where there is no such fusion or it is
// made of what is made of it.
void DocumentReader::checkResults(FusionList& fusions) const {
  for (auto& one : fusions) {
    for (const Side side : {Side::Part, Side::Base}) {
      const FusionId upstream = one->upstream(side);
      if (upstream == 0) {
        continue;
      }
      Fusion fusion = *one;
      const Fusion* source = graftsman::find(fusions, upstream);
      const std::vector<FusionId> needed = upstreamOf(fusions, upstream);
      if (source != nullptr && std::find(needed.begin(), needed.end(), fusion.id) == needed.end()) {
        setAsset(fusion, side, edits::resultAsset(*source));
      } else {
        lose_({ErrorCode::FileMalformed,
               std::string("The ") + name(side) + " of “" + label(fusion) +
                   "” is the result of a fusion that is missing or made of it, and was left out. "
                   "Load a mesh.",
               side},
              true);
        setAsset(fusion, side, nullptr);
      }
      one = std::make_shared<const Fusion>(std::move(fusion));
    }
  }
}

std::shared_ptr<const Variant> DocumentReader::variant(const json& record, int number) const {
  const json* list = record.is_object() ? find(record, "fusions") : nullptr;
  if (list == nullptr || !list->is_array() || list->empty()) {
    return nullptr;
  }
  Variant variant;
  variant.id = id(record, "id", number);
  variant.name = textOr(record, "name", "Variant " + std::to_string(variant.id));
  variant.note = textOr(record, "note", "");
  const json* starred = find(record, "starred");
  variant.starred = starred != nullptr && starred->is_boolean() && starred->get<bool>();
  variant.fusions = fusions(*list, {});
  variant.shown = shown(record, variant.fusions);
  return std::make_shared<const Variant>(std::move(variant));
}

VariantList DocumentReader::variants(const json& list) const {
  VariantList read;
  for (std::size_t i = 0; list.is_array() && i < list.size(); ++i) {
    const std::shared_ptr<const Variant> one = variant(list[i], static_cast<int>(i) + 1);
    if (!one) {
      lose_({ErrorCode::FileMalformed,
             "Variant " + std::to_string(i + 1) + " of the project cannot be understood and was left out."},
            false);
    } else if (graftsman::find(read, one->id) != nullptr) {
      lose_({ErrorCode::FileMalformed, "Two of the project's variants have the number " +
                                           std::to_string(one->id) + "; the second was left out."},
            false);
    } else {
      read.push_back(one);
    }
  }
  return read;
}

void DocumentReader::readInputs(const json& object, Fusion& read) const {
  const auto complain = [&](const Malformed& wrong) {
    lose_({wrong.code == ErrorCode::ScenarioMalformed ? ErrorCode::FileMalformed : wrong.code,
           "In the project's document.json " + wrong.what +
               " The default was taken instead; look at it before you save."},
          true);
  };
  readSettings(object, read.inputs, complain);
  try {
    read.inputs.loop = loop(demand(object, "cvp", "a list of pairs"), Places::Known);
    read.closed = boolean(demand(object, "closed", "true or false"), "closed");
  } catch (const Malformed& wrong) {
    complain(wrong);
  }
  dropUnknownPoints(read);
  constexpr std::size_t kShortestLoop = 3;
  read.closed = read.closed && read.inputs.loop.size() >= kShortestLoop;
}

// Takes out the pairs that name what their meshes do not have.
void DocumentReader::dropUnknownPoints(Fusion& fusion) const {
  FusionInputs& inputs = fusion.inputs;
  const auto knows = [&](Side side, const SurfacePoint& point) {
    const auto& mesh = side == Side::Part ? inputs.part : inputs.base;
    // On a result a point is known by its place, on a mesh of the file by its number.
    if (point.place.has_value() != (fusion.upstream(side) != 0) && fusion.of(side)) {
      return false;
    }
    return !mesh || (point.vertex >= 0 ? point.vertex < mesh->vertexCount() : point.face < mesh->faceCount());
  };
  Loop kept;
  std::vector<int> lost;
  std::string numbers;
  for (std::size_t i = 0; i < inputs.loop.size(); ++i) {
    const CVP& pair = inputs.loop[i];
    if (knows(Side::Part, pair.part) && knows(Side::Base, pair.base)) {
      kept.push_back(pair);
    } else {
      lost.push_back(static_cast<int>(i));
      numbers += (numbers.empty() ? "" : ", ") + std::to_string(i);
    }
  }
  if (!lost.empty()) {
    lose_({ErrorCode::LoopIndexOutOfRange,
           "The loop named vertices or faces that its meshes do not have; these pairs were left "
           "out: " +
               printable(numbers, kLongestList) + ". Insert them again.",
           {},
           std::move(lost)},
          true);
    inputs.loop = std::move(kept);
  }
}

}  // namespace graftsman
