// A substitute for std::stringstream.  Role: tinygltf composes messages with it in WebAssembly
// (cmake/HgpThirdParty.cmake), where std::stringstream would link all streams and locales.
#pragma once

#include <concepts>
#include <ostream>
#include <string>
#include <string_view>

namespace hgp::io {

class TextStream {
 public:
  TextStream& operator<<(std::string_view text) {
    text_ += text;
    return *this;
  }
  TextStream& operator<<(char c) {
    text_ += c;
    return *this;
  }
  TextStream& operator<<(std::integral auto number) {
    text_ += std::to_string(number);
    return *this;
  }
  /// std::endl
  TextStream& operator<<(std::ostream& (*)(std::ostream&)) { return *this << '\n'; }

  const std::string& str() const { return text_; }

 private:
  std::string text_;
};

}  // namespace hgp::io
