#include "short_document.h"

namespace hgp::cli {

ShortDocument::ShortDocument(const std::string& source) {
  const auto keep = [this](int, Json::parse_event_t event, Json& value) {
    switch (event) {
      case Json::parse_event_t::key:
        around_.back().key = value.get<std::string>();
        return true;
      case Json::parse_event_t::object_start:
      case Json::parse_event_t::array_start:
        around_.push_back({event == Json::parse_event_t::array_start, "", 0});
        return true;
      case Json::parse_event_t::object_end:
      case Json::parse_event_t::array_end:
        around_.pop_back();
        return around_.empty() || !around_.back().isArray || isKept(value);
      case Json::parse_event_t::value:
        return true;
    }
    return true;
  };
  json = Json::parse(source, keep);
}

/// Whether an element of an array is kept; components are given their number.
bool ShortDocument::isKept(Json& value) {
  const std::size_t element = around_.back().count++;
  if (around_.size() < 2 || !value.is_object()) return true;
  const std::string& array = around_[around_.size() - 2].key;
  if (array == "cones" && around_.size() == 3 && around_[0].key == "cones") {
    ++cones;
    return false;
  }
  if (array != "components") return true;
  value["number"] = element;
  if (element < kMaxComponents) return true;
  const auto isFine = value.find("certifiedBeforeStoring");
  if (isFine != value.end()) return !isFine->get<bool>();
  const auto reasons = value.find("reasons");
  if (reasons == value.end() || !reasons->empty()) return true;
  ++untold;
  return false;
}

}  // namespace hgp::cli
