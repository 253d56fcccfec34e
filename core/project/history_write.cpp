#include <algorithm>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "core/project/history_file.h"

namespace graftsman {

using namespace fusion_json;

namespace {

// Bytes that an item takes beside its own text: a comma, a line's end, a fusion's part and base.
constexpr std::size_t kAround = 4;
constexpr std::size_t kSources = 80;
// The names of the lists, and the numbers at the beginning.
constexpr std::size_t kFrame = 200;

std::string dumped(const json& value) {
  return value.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::size_t bytesOf(const TriangleMesh& mesh) {
  return mesh.points().size() * sizeof(Point) + mesh.faces().size() * sizeof(Face);
}

// Different values, each with its number: found again by its address, or else by its text.
class Table {
 public:
  struct Item {
    const void* value;
    std::string text;
  };

  [[nodiscard]] std::optional<std::size_t> find(const void* value) const {
    const auto found = numbers_.find(value);
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }

  // The value's number, and whether it is a new one. Two values of equal keys are the same.
  std::pair<std::size_t, bool> add(const void* value, const std::string& key, std::string text) {
    const auto [known, isNew] = byKey_.emplace(key, items_.size());
    if (isNew) {
      items_.push_back({value, std::move(text)});
    }
    numbers_[value] = known->second;
    return {known->second, isNew};
  }

  // Forgets all but the first.
  void shrink(std::size_t count) {
    const auto isLater = [count](const auto& one) { return one.second >= count; };
    std::erase_if(numbers_, isLater);
    std::erase_if(byKey_, isLater);
    items_.resize(count);
  }

  [[nodiscard]] const std::vector<Item>& items() const { return items_; }

 private:
  std::unordered_map<const void*, std::size_t> numbers_;
  std::unordered_map<std::string, std::size_t> byKey_;
  std::vector<Item> items_;
};

class HistoryWriter {
 public:
  HistoryWriter(const History& history, const Document& document, const HistoryFile::Values& values)
      : history_(history), values_(values) {
    noteMeshes(document.fusions);
    for (const auto& variant : document.variants) {
      noteMeshes(variant->fusions);
    }
  }

  std::string text(const json& others, const HistoryFile::Source& source) {
    used_.bytes = kFrame + dumped(others).size();
    const auto present = static_cast<std::size_t>(history_.index);
    if (!admit(present, nullptr, nullptr)) {
      return {};
    }
    std::size_t first = present;
    std::size_t last = present;
    const auto room = [&] { return last - first < history_bounds::kMostSteps; };
    while (last < history_.steps.size() && room() &&
           admit(last + 1, &history_.states[last], &history_.steps[last])) {
      ++last;
    }
    while (first > 0 && room() && admit(first - 1, &history_.states[first], &history_.steps[first - 1])) {
      --first;
    }
    return first == last ? std::string() : assembled(first, last, others, source);
  }

 private:
  // What counts towards the bounds.
  struct Used {
    std::size_t bytes = 0;
    std::size_t meshBytes = 0;
    std::size_t listed = 0;
  };

  void noteMeshes(const FusionList& fusions) {
    for (const auto& fusion : fusions) {
      for (const Side side : {Side::Part, Side::Base}) {
        if (fusion->of(side) && fusion->upstream(side) == 0) {
          meshes_.insert(fusion->of(side)->mesh.get());
        }
      }
    }
  }

  // Takes the state in, with the step between it and its neighbour, if all of it fits; otherwise nothing.
  bool admit(std::size_t state, const Document* neighbour, const HistoryStep* step) {
    const Used before = used_;
    const std::size_t fusions = fusions_.items().size();
    const std::size_t variants = variants_.items().size();
    added_.clear();
    std::string& text = states_[state];
    text = textOf(history_.states[state], neighbour);
    used_.bytes += text.size() + kAround;
    if (step != nullptr) {
      used_.bytes += dumped(jsonOf(*step)).size() + kAround;
    }
    const bool fits = used_.bytes <= history_bounds::kMostBytes &&
                      used_.meshBytes <= history_bounds::kMostMeshBytes &&
                      used_.listed <= history_bounds::kMostListed;
    if (!fits) {
      used_ = before;
      fusions_.shrink(fusions);
      variants_.shrink(variants);
      for (const TriangleMesh* mesh : added_) {
        meshes_.erase(mesh);
      }
    }
    return fits;
  }

  std::string textOf(const Document& state, const Document* neighbour) {
    used_.listed += state.fusions.size() + state.variants.size();
    json lists = json::object();
    if (neighbour == nullptr || state.fusions != neighbour->fusions) {
      lists["fusions"] = numbersOf(state.fusions);
    }
    if (neighbour == nullptr || state.variants != neighbour->variants) {
      json numbers = json::array();
      for (const auto& variant : state.variants) {
        numbers.push_back(numberOf(*variant));
      }
      lists["variants"] = std::move(numbers);
    }
    return dumped(lists);
  }

  json numbersOf(const FusionList& fusions) {
    json numbers = json::array();
    for (const auto& fusion : fusions) {
      numbers.push_back(numberOf(*fusion));
    }
    return numbers;
  }

  std::size_t numberOf(const Fusion& fusion) {
    if (const auto known = fusions_.find(&fusion)) {
      return *known;
    }
    std::string text = dumped(values_(fusion));
    std::string key = text;
    for (const Side side : {Side::Part, Side::Base}) {
      const auto upstream = static_cast<std::size_t>(fusion.upstream(side));
      key += ' ' + std::to_string(upstream != 0 ? upstream
                                                : reinterpret_cast<std::uintptr_t>(fusion.of(side).get()));
    }
    const std::size_t size = text.size();
    const auto [number, isNew] = fusions_.add(&fusion, key, std::move(text));
    if (isNew) {
      used_.bytes += size + kSources + kAround;
      countMeshes(fusion);
    }
    return number;
  }

  void countMeshes(const Fusion& fusion) {
    for (const Side side : {Side::Part, Side::Base}) {
      const TriangleMesh* mesh =
          fusion.of(side) && fusion.upstream(side) == 0 ? fusion.of(side)->mesh.get() : nullptr;
      if (mesh != nullptr && meshes_.insert(mesh).second) {
        used_.meshBytes += bytesOf(*mesh);
        added_.push_back(mesh);
      }
    }
  }

  std::size_t numberOf(const Variant& variant) {
    if (const auto known = variants_.find(&variant)) {
      return *known;
    }
    std::string text = dumped({{"id", variant.id},
                               {"name", variant.name},
                               {"note", variant.note},
                               {"starred", variant.starred},
                               {"shown", variant.shown},
                               {"fusions", numbersOf(variant.fusions)}});
    const std::string key = text;
    const auto [number, isNew] = variants_.add(&variant, key, std::move(text));
    if (isNew) {
      used_.bytes += key.size() + kAround;
      used_.listed += variant.fusions.size();
    }
    return number;
  }

  static json jsonOf(const HistoryStep& step) {
    json written = {{"text", step.text}, {"shown", {step.shownBefore, step.shownAfter}}};
    if (step.cv) {
      written["cv"] = *step.cv;
    }
    if (step.curvePoint) {
      written["curve_point"] = *step.curvePoint;
    }
    return written;
  }

  std::string assembled(std::size_t first, std::size_t last, const json& others,
                        const HistoryFile::Source& source) {
    std::string text = "{\"format\":" + std::to_string(HistoryFile::kFormat) +
                       ",\"index\":" + std::to_string(static_cast<std::size_t>(history_.index) - first);
    const auto list = [&](const char* name, std::size_t from, std::size_t to, const auto& item) {
      text += std::string(",\n\"") + name + "\":[";
      for (std::size_t i = from; i < to; ++i) {
        text += (i == from ? "\n" : ",\n") + item(i);
      }
      text += "]";
    };
    list("fusions", 0, fusions_.items().size(), [&](std::size_t i) {
      const auto& [value, values] = fusions_.items()[i];
      const auto& fusion = *static_cast<const Fusion*>(value);
      const std::string part = dumped(source(fusion.part));
      return values.substr(0, values.size() - 1) + ",\"part\":" + part +
             ",\"base\":" + dumped(source(fusion.base)) + "}";
    });
    list("variants", 0, variants_.items().size(), [&](std::size_t i) { return variants_.items()[i].text; });
    list("states", first, last + 1, [&](std::size_t i) { return states_.at(i); });
    list("steps", first, last, [&](std::size_t i) { return dumped(jsonOf(history_.steps[i])); });
    for (const auto& [key, value] : others.items()) {
      text += ",\n" + dumped(key) + ":" + dumped(value);
    }
    return text + "}\n";
  }

  const History& history_;
  const HistoryFile::Values& values_;
  Table fusions_;
  Table variants_;
  std::map<std::size_t, std::string> states_;  // texts, by number in the history
  std::set<const TriangleMesh*> meshes_;       // that the document has or that are counted
  std::vector<const TriangleMesh*> added_;     // of these, by the state that is looked at
  Used used_;
};

}  // namespace

std::string HistoryFile::write(const History& history, const Document& document, const json& others,
                               const Values& values, const Source& source) {
  const auto present = static_cast<std::size_t>(history.index);
  const bool ofDocument = !history.steps.empty() && history.states.size() == history.steps.size() + 1 &&
                          present < history.states.size() && history.states[present] == document;
  return ofDocument ? HistoryWriter(history, document, values).text(others, source) : std::string();
}

}  // namespace graftsman
