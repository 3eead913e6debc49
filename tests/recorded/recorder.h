// What a scenario gives, as one line of text that a recording is compared with.  Role: sees every change of a result,
// whether it is wanted or not; laws say which of them are right.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "hgp/api/session.h"
#include "recorded/shapes.h"

namespace hgp::recorded {

class Recorder {
 public:
  /// A value that a reader of the recording understands.
  void fact(std::string_view key, const std::string& value);
  void fact(std::string_view key, long long value) { fact(key, std::to_string(value)); }

  void bytes(std::string_view key, const void* data, std::size_t size);
  void text(std::string_view key, const std::string& text) { bytes(key, text.data(), text.size()); }
  /// Bit by bit: of what `--reproducible` promises, or of integers.
  template <class T>
  void numbers(std::string_view key, const std::vector<T>& all) {
    bytes(key, all.data(), all.size() * sizeof(T));
  }
  /// Without times and versions; measured numbers to six digits, as they may depend on the C library.
  void json(std::string_view key, const std::string& text);
  void failure(std::string_view key, const Failure& failure);
  void notes(std::string_view key, const Notes& notes);

  const std::string& line() const { return line_; }

 private:
  std::string line_;
};

struct Scenario {
  std::string name;
  std::function<void(Recorder&)> run;
  friend void PrintTo(const Scenario& scenario, std::ostream* out) { *out << scenario.name; }
};

/// The map of a session and all that is said of it.
void recordMap(Recorder& r, const api::Session& session);
/// parametrize() with options as JSON, and the map or the failure.
void solve(Recorder& r, api::Session& session,
           const std::optional<prescription::Prescription>& cones, std::string_view options);
prescription::Prescription readCones(const std::string& json);
api::Session loaded(const MeshData& mesh);
api::Session loadedFile(const std::string& name, const std::string& text,
                        const api::LoadOptions& options = {});

/// Reads a file, says what is known of it, solves it, and writes, reads and verifies it with each of some WriteOptions.
void through(Recorder& r, const std::string& name, const std::string& text, const char* load = "{}",
             const std::vector<const char*>& ways = {"{}"});

/// Names and contents of files of a few triangles, in every format but glTF.
std::vector<std::pair<std::string, std::string>> smallFiles();
/// A GLB with one mesh of every way to store it.
std::string smallGlb();

std::vector<Scenario> maps(), prescriptions(), grids(), files(), gltfFiles(), verdicts(), edits();
std::vector<Scenario> wrongFiles();

}  // namespace hgp::recorded
