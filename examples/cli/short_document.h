// A report or certificate without what the text for people only counts.  Role: a map may have ten thousands of components,
// and as a tree of values its report takes several times its text.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace hgp::cli {

inline constexpr std::size_t kMaxComponents = 20;  ///< listed individually if nothing is wrong

class ShortDocument {
 public:
  using Json = nlohmann::ordered_json;
  explicit ShortDocument(const std::string& source);

  Json json;               ///< each component has its number as `number`
  std::size_t cones = 0;   ///< of the prescription in a report, which are left out
  std::size_t untold = 0;  ///< components of the certificate that are left out

 private:
  struct Container {
    bool isArray = false;
    std::string key;        ///< of an object, the member that is read
    std::size_t count = 0;  ///< of an array, the elements so far
  };
  bool isKept(Json& value);

  std::vector<Container> around_;
};

}  // namespace hgp::cli
