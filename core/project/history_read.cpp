#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "core/project/document_edits.h"
#include "core/project/history_file.h"

namespace graftsman {

using namespace fusion_json;

namespace {

constexpr std::array kKeys = {"format", "index", "fusions", "variants", "states", "steps"};

[[noreturn]] void wrong(const std::string& what) {
  throw Malformed{ErrorCode::FileMalformed, what};
}

const json& listOf(const json& object, const char* key) {
  const json* list = object.is_object() ? find(object, key) : nullptr;
  if (list == nullptr || !list->is_array()) {
    wrong(std::string("it has no list \"") + key + "\"");
  }
  return *list;
}

// A whole number below the end, or nothing.
std::optional<std::size_t> below(std::size_t end, const json& value) {
  const bool given = value.is_number_unsigned() && value.get<std::uint64_t>() < end;
  return given ? std::optional(value.get<std::size_t>()) : std::nullopt;
}

template <class List>
bool idsDiffer(const List& list) {
  std::set<int> ids;
  return std::all_of(list.begin(), list.end(), [&](const auto& one) { return ids.insert(one->id).second; });
}

// Whether every result that a fusion is made of is the result of one of them, and none is made of itself.
bool wellFounded(const FusionList& fusions) {
  std::map<FusionId, int> missing;  // of each fusion, sources that are not known to be well-founded
  std::multimap<FusionId, FusionId> users;
  std::vector<FusionId> ready;
  for (const auto& fusion : fusions) {
    int& count = missing[fusion->id] = 0;
    for (const Side side : {Side::Part, Side::Base}) {
      if (const FusionId upstream = fusion->upstream(side)) {
        users.emplace(upstream, fusion->id);
        ++count;
      }
    }
    if (count == 0) {
      ready.push_back(fusion->id);
    }
  }
  std::size_t founded = 0;
  for (; !ready.empty(); ++founded) {
    const auto [begin, end] = users.equal_range(ready.back());
    ready.pop_back();
    for (auto user = begin; user != end; ++user) {
      if (--missing[user->second] == 0) {
        ready.push_back(user->second);
      }
    }
  }
  return founded == fusions.size();
}

class HistoryReader {
 public:
  HistoryReader(const json& text, const Document& document, const DocumentReader& reader)
      : text_(text), document_(document), reader_(reader) {}

  History read() {
    const json& states = listOf(text_, "states");
    const json& steps = listOf(text_, "steps");
    if (steps.size() > history_bounds::kMostSteps || states.size() != steps.size() + 1) {
      wrong("its numbers of steps and of states do not fit");
    }
    const std::optional<std::size_t> present = below(states.size(), demand(text_, "index", "a number"));
    if (!present) {
      wrong("it does not say which state is the present one");
    }
    readFusions();
    readVariants();
    History history;
    history.index = static_cast<int>(*present);
    history.states.resize(states.size());
    history.states[*present] = state(states[*present], nullptr);
    if (!(history.states[*present] == document_)) {
      wrong("its present state is not the document that the project holds");
    }
    for (std::size_t i = *present + 1; i < states.size(); ++i) {
      history.states[i] = state(states[i], &history.states[i - 1]);
    }
    for (std::size_t i = *present; i-- > 0;) {
      history.states[i] = state(states[i], &history.states[i + 1]);
    }
    for (const json& one : steps) {
      history.steps.push_back(step(one));
    }
    return history;
  }

 private:
  void readFusions() {
    std::map<FusionId, std::shared_ptr<const Fusion>> ofDocument;
    for (const auto& fusion : document_.fusions) {
      ofDocument[fusion->id] = fusion;
    }
    for (const json& one : listOf(text_, "fusions")) {
      if (!one.is_object()) {
        wrong("a fusion in it is no object");
      }
      auto fusion = std::make_shared<Fusion>(reader_.fusion(one, {}));
      fusion->id = DocumentReader::id(one, "id", 0);
      if (fusion->id == 0) {
        wrong("a fusion in it has no number");
      }
      const auto same = ofDocument.find(fusion->id);
      if (same != ofDocument.end() && *same->second == *fusion) {
        fusions_.push_back(same->second);
        unnamed_.push_back(nullptr);
      } else {
        fusions_.push_back(fusion);
        unnamed_.push_back(std::move(fusion));
      }
    }
  }

  void readVariants() {
    for (const json& one : listOf(text_, "variants")) {
      Variant variant;
      variant.fusions = fusionList(listOf(one, "fusions"));
      variant.id = DocumentReader::id(one, "id", 0);
      if (variant.id == 0) {
        wrong("a variant in it has no number");
      }
      variant.name = DocumentReader::textOr(one, "name", "Variant " + std::to_string(variant.id));
      variant.note = DocumentReader::textOr(one, "note", "");
      const json* starred = find(one, "starred");
      variant.starred = starred != nullptr && starred->is_boolean() && starred->get<bool>();
      variant.shown = DocumentReader::shown(one, variant.fusions);
      const auto same = std::find_if(document_.variants.begin(), document_.variants.end(),
                                     [&](const auto& known) { return *known == variant; });
      variants_.push_back(
          same != document_.variants.end() ? *same : std::make_shared<const Variant>(std::move(variant)));
    }
  }

  FusionList fusionList(const json& numbers) {
    FusionList list;
    for (const json& number : numbers) {
      const auto known = below(fusions_.size(), number);
      if (!known) {
        wrong("a state in it names a fusion that it does not have");
      }
      list.push_back(fusions_[*known]);
    }
    count(list.size());
    if (list.empty() || !idsDiffer(list) || !wellFounded(list)) {
      wrong("the fusions of a state in it do not fit together");
    }
    for (const json& number : numbers) {
      nameSources(number.get<std::size_t>(), list);
    }
    return list;
  }

  // Gives the results that the fusion is made of their names, if this is the first list that it is in.
  void nameSources(std::size_t number, const FusionList& list) {
    const std::shared_ptr<Fusion> fusion = std::exchange(unnamed_[number], nullptr);
    for (const Side side : {Side::Part, Side::Base}) {
      if (const FusionId upstream = fusion ? fusion->upstream(side) : 0) {
        setAsset(*fusion, side, edits::resultAsset(*graftsman::find(list, upstream)));
      }
    }
  }

  Document state(const json& lists, const Document* neighbour) {
    if (!lists.is_object()) {
      wrong("a state in it is no object");
    }
    Document state;
    if (neighbour != nullptr && !lists.contains("fusions")) {
      count(neighbour->fusions.size());
      state.fusions = neighbour->fusions;
    } else {
      state.fusions = fusionList(listOf(lists, "fusions"));
    }
    if (neighbour != nullptr && !lists.contains("variants")) {
      count(neighbour->variants.size());
      state.variants = neighbour->variants;
      return state;
    }
    for (const json& number : listOf(lists, "variants")) {
      const auto known = below(variants_.size(), number);
      if (!known) {
        wrong("a state in it names a variant that it does not have");
      }
      state.variants.push_back(variants_[*known]);
    }
    count(state.variants.size());
    if (!idsDiffer(state.variants)) {
      wrong("a state in it has two variants of one number");
    }
    return state;
  }

  void count(std::size_t listed) {
    listed_ += listed;
    if (listed_ > history_bounds::kMostListed) {
      wrong("it lists more fusions and variants than this program keeps");
    }
  }

  static HistoryStep step(const json& one) {
    if (!one.is_object()) {
      wrong("a step in it is no object");
    }
    HistoryStep step;
    step.text = DocumentReader::textOr(one, "text", "");
    const json* shown = find(one, "shown");
    if (shown == nullptr || !shown->is_array() || shown->size() != 2) {
      wrong("a step in it does not say which fusions were shown");
    }
    step.shownBefore = index((*shown)[0], "shown", "two numbers of fusions");
    step.shownAfter = index((*shown)[1], "shown", "two numbers of fusions");
    const auto touched = [&](const char* key, std::optional<int>& target) {
      if (const json* number = find(one, key)) {
        target = index(*number, key, "a number");
      }
    };
    touched("cv", step.cv);
    touched("curve_point", step.curvePoint);
    return step;
  }

  const json& text_;
  const Document& document_;
  const DocumentReader& reader_;
  FusionList fusions_;
  std::vector<std::shared_ptr<Fusion>> unnamed_;  // of fusions_, those that no list was met with yet
  VariantList variants_;
  std::size_t listed_ = 0;
};

}  // namespace

bool HistoryFile::isNewer(const json& text) {
  const json* format = text.is_object() ? find(text, "format") : nullptr;
  return format != nullptr && format->is_number_unsigned() && *format > kFormat;
}

History HistoryFile::read(const json& text, const Document& document, const DocumentReader& reader) {
  return HistoryReader(text, document, reader).read();
}

json HistoryFile::others(json text) {
  for (const char* key : kKeys) {
    text.erase(key);
  }
  return text;
}

}  // namespace graftsman
