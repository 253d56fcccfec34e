#include "core/io/scenario_check.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <vector>

#include "core/io/printable.h"

namespace graftsman {
namespace {

using nlohmann::json;

constexpr std::array<std::string_view, 6> kAdjustment = {"rigid",     "scale",   "line_field",
                                                         "exact_fit", "epsilon", "max_iterations"};
// The keys whose values are looked into.
constexpr std::array<std::string_view, 2> kChecked = {"adjustment", "cvp"};

/// Follows the parser, and stops it at the first slip.
class SlipFinder : public nlohmann::json_sax<json> {
 public:
  [[nodiscard]] const std::string& slip() const { return slip_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(json::number_integer_t) override { return true; }
  bool number_unsigned(json::number_unsigned_t) override { return true; }
  bool number_float(json::number_float_t, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(json::binary_t&) override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override {
    return false;
  }

  bool start_object(std::size_t) override {
    open_.emplace_back();
    return true;
  }
  bool end_object() override {
    open_.pop_back();
    return true;
  }

  bool key(std::string& key) override {
    const bool top = open_.size() == 1;
    if (top) {
      section_ = key;
    } else if (std::find(kChecked.begin(), kChecked.end(), section_) == kChecked.end()) {
      return true;
    }
    if (!open_.back().insert(key).second) {
      slip_ = named(key) + " is given twice; leave one of them out.";
    } else if (!top && section_ == "adjustment" && open_.size() == 2 &&
               std::find(kAdjustment.begin(), kAdjustment.end(), key) == kAdjustment.end()) {
      slip_ = named(key) + " is no setting; \"adjustment\" takes ";
      for (const std::string_view known : kAdjustment) {
        slip_ += std::string(known) + (known == kAdjustment.back() ? "." : ", ");
      }
    }
    return slip_.empty();
  }

 private:
  [[nodiscard]] std::string named(const std::string& key) const {
    constexpr std::size_t kLongest = 80;
    return "\"" + (open_.size() > 1 ? section_ + "." : "") + printable(key, kLongest) + "\"";
  }

  std::vector<std::set<std::string>> open_;  // the keys so far of the objects that the parser is in
  std::string section_;                      // the outermost object's key that it is in
  std::string slip_;
};

}  // namespace

std::string slipIn(std::string_view scenario) {
  SlipFinder finder;
  json::sax_parse(scenario, &finder);
  return finder.slip();
}

}  // namespace graftsman
