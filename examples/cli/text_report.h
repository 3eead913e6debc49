// The JSON documents as text for people.  Role: computes nothing; prints the numbers that programs
// read.
#pragma once

#include <string>

namespace hgp::cli {

/// Colours words if the terminal supports it and the user has not turned it off.
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
