// The JSON documents as text for people.  Role: nothing is computed here; what is printed is what a
// program would read.
#pragma once

#include <string>

namespace hgp::cli {

/// Wraps words in colour when the terminal and the person want it.
struct Style {
  bool isColored = false;
  std::string good(const std::string& text) const;
  std::string bad(const std::string& text) const;
  std::string strong(const std::string& text) const;
};

std::string inspectText(const std::string& json, const Style& style);
std::string checkText(const std::string& json, const Style& style);
std::string certificateText(const std::string& json, const Style& style);
std::string reportText(const std::string& json, const Style& style);

/// A text from a file, safe for a terminal: control bytes become '?'.
std::string printable(const std::string& text);

}  // namespace hgp::cli
