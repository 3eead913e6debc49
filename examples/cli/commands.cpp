// budget: a method for every command
#include "commands.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "also.h"
#include "files.h"
#include "hgp/api/session.h"
#include "hgp/base/check.h"
#include "hgp/base/counted.h"
#include "hgp/base/phrase.h"
#include "hgp/base/threads.h"
#include "hgp/features/creases.h"
#include "hgp/prescription/feature_files.h"
#include "progress_line.h"
#include "quad_files.h"
#include "side_files.h"
#include "text_report.h"
#include "whole_file.h"

namespace hgp::cli {
namespace {

constexpr int kNoMapExit = 6;

class Run {
 public:
  explicit Run(const Arguments& arguments)
      : a_(arguments), progress_(!a_.isQuiet && !a_.hasNoProgress, a_.timeLimit) {
    style_.isColored = isColored(Stream::kOutput);
    messageStyle_.isColored = isColored(Stream::kError);
  }

  int run() {
    const ThreadScope threads(a_.threads);
    if (a_.isReproducible) api::setReproducible(true);
    if (Status usable = checkNames(); !usable) {
      // The name of the report may be the error, so nothing is written to it.
      return fail(usable.error(), a_.json == "-");
    }
    for (const std::string& output : outputs())
      if (Status possible = checkWritable(output); !possible)
        return fail(possible.error(), output != a_.json);
    Result<io::FileSet> files = openFiles(a_.input, a_.format, a_.root, a_.load.limits.maxBytes);
    if (!files) return fail(files.error());
    const bool isQuadObj =
        a_.command == Command::kQuads && std::filesystem::path(a_.output).extension() == ".obj";
    if (a_.command == Command::kParam || isQuadObj) {
      if (Status possible = checkSideFiles(*files, a_); !possible) return fail(possible.error());
    }
    const bool mayBeWhole =
        a_.isEveryMesh && (a_.command == Command::kParam || a_.command == Command::kVerify);
    resolve_ = files->resolve;
    if (Status loaded = session_.load(std::move(*files), a_.load); !loaded) {
      return fail(loaded.error());
    }
    if (mayBeWhole && session_.surfaceCount() > 1) return wholeFile();
    switch (a_.command) {
      case Command::kInspect:
        return inspect();
      case Command::kCheck:
        return check();
      case Command::kCones:
        return cones();
      case Command::kFeatures:
        return features();
      case Command::kParam:
      case Command::kQuads:
        return param();
      case Command::kVerify:
        return verify();
    }
    return exitCode(ErrorCode::kInternal);
  }

 private:
  bool isColored(Stream stream) const {
    if (a_.color != "auto") return a_.color == "always";
    const char* noColor = std::getenv("NO_COLOR");
    return (noColor == nullptr || *noColor == '\0') && isCleverTerminal(stream);
  }

  std::string inputName() const { return a_.input == "-" ? "standard input" : a_.input; }

  /// A line on standard error, with the file that it is about first.
  void tell(const std::string& message) {
    progress_.clear();
    std::fprintf(stderr, "hgp: %s: %s\n", printable(inputName()).c_str(),
                 printable(message).c_str());
  }

  void tell(const Notes& notes) {
    progress_.clear();
    for (const Note& note : notes)
      if (!a_.isQuiet) std::fprintf(stderr, "  note: %s\n", printable(phrase(note)).c_str());
  }

  /// hgp-error with the file.
  std::string errorDocument(const Failure& failure) const {
    auto json = nlohmann::ordered_json::parse(api::errorJson(failure));
    json["file"] = inputName();
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  }

  /// The exit code of a result that is written and not certified; with --quiet, nothing else said so.
  int notCertified() {
    if (a_.isQuiet) tell("written, but not certified");
    return kNoMapExit;
  }

  /// Reports a failure on standard error and, if requested, as JSON.
  int fail(const Failure& failure, bool isReported = true) {
    tell(told(failure));
    for (std::size_t i = 0; i < failure.where.size() && i < 5; ++i) {
      const Where& w = failure.where[i];
      if (w.kind == Where::Kind::kLine || w.kind == Where::Kind::kByte) continue;
      const char* kind = w.kind == Where::Kind::kVertex ? "vertex"
                         : w.kind == Where::Kind::kFace ? "triangle"
                         : w.kind == Where::Kind::kLoop ? "loop"
                                                        : "edge";
      std::fprintf(stderr, "     at %s %lld", kind, static_cast<long long>(w.id));
      if (w.kind == Where::Kind::kEdge)
        std::fprintf(stderr, "–%lld", static_cast<long long>(w.other));
      std::fputc('\n', stderr);
    }
    if (!a_.json.empty() && isReported) {
      const Status written = writeText(a_.json, errorDocument(failure));
      // Not reported again if writing was the failure.
      if (!written && written.error().message != failure.message) tell(told(written.error()));
    }
    return exitCode(failure.code);
  }

  /// Writes the document to --json, and the text to standard output unless the document is written there.
  Status publish(const std::string& json, const std::string& text, bool isMessage = false) {
    progress_.clear();
    if (!a_.json.empty()) {
      if (Status written = writeText(a_.json, json); !written) return written;
    }
    if (a_.isQuiet || (!isMessage && a_.json == "-")) return Done{};
    if (!isMessage) return writeText("-", text);
    std::fputs(text.c_str(), stderr);
    return Done{};
  }

  int finish(const Status& status, int good) { return status ? good : fail(status.error()); }

  std::vector<std::string> outputs() const {
    std::vector<std::string> out = {a_.output, a_.json, a_.xref};
    out.insert(out.end(), a_.also.begin(), a_.also.end());
    out.insert(out.end(), {a_.faces, a_.loops});
    if (a_.command == Command::kQuads) out.push_back(objBeside(a_.output));
    return out;
  }

  /// Checks that no output replaces an input or another output; only the map may replace the mesh.
  Status checkNames() const {
    const auto refuse = [](const std::string& text) {
      return Failure{ErrorCode::kUsage, "write", text, {}};
    };
    const std::vector<std::string> outputs = this->outputs();
    const bool isResult = a_.command == Command::kParam || a_.command == Command::kQuads;
    const bool mayReplace = a_.mayOverwrite && isResult;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      for (const std::string& input : {a_.input, a_.cones, a_.field, a_.convert, a_.features,
                                       a_.balance, a_.transfer, a_.from}) {
        if (!isSameFile(outputs[i], input)) continue;
        if (i == 0 && mayReplace && input == a_.input) continue;
        const bool isMap = i == 0 && isResult && input == a_.input;
        return refuse(outputs[i] + (isMap ? " is the input; --force allows to replace it"
                                          : " is read; it cannot be written, too"));
      }
      for (std::size_t j = i + 1; j < outputs.size(); ++j) {
        if (isSameFile(outputs[i], outputs[j])) {
          return refuse(outputs[i] + " is named for two outputs");
        }
      }
    }
    return Done{};
  }

  int inspect() {
    Result<api::Verdict> verdict = session_.inspect();
    if (!verdict) return fail(verdict.error());
    if (!a_.loops.empty() && verdict->isGood) {
      if (Status done = writeLoops(session_, a_.loops); !done) return fail(done.error());
    }
    return finish(publish(verdict->json, inspectText(verdict->json, style_)),
                  verdict->isGood ? 0 : exitCode(ErrorCode::kUnsupported));
  }

  static std::string withoutGz(std::string name) {
    if (name.size() > 3 && name.substr(name.size() - 3) == ".gz") name.resize(name.size() - 3);
    return name;
  }

  Result<prescription::Prescription> readFileOf(const std::string& path) {
    Result<io::Bytes> bytes = readFile(path, a_.load.limits.maxBytes);
    if (!bytes) return bytes.error();
    const std::string name = withoutGz(path);
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    Result<prescription::Prescription> read = api::readPrescription(name, text, a_.q.value_or(4));
    if (!read) {
      Failure failure = read.error();
      failure.message = path + ": " + failure.message;
      return failure;
    }
    if (a_.q && read->q != *a_.q) {
      return Failure{
          ErrorCode::kUsage,
          "prescription",
          formatText("--q %d contradicts %s, which has q = %d", *a_.q, path.c_str(), read->q),
          {}};
    }
    return read;
  }

  /// Adds the features of --rims and --features.
  Status addFeatures(prescription::PrescribedFeatures& features) {
    Result<std::optional<prescription::PrescribedFeatures>> list = readFeatureList();
    if (!list) return list.error();
    prescription::addFeatures(features, std::move(*list), a_.everyMesh);
    return Done{};
  }

  /// The file of --features, if there is one.
  Result<std::optional<prescription::PrescribedFeatures>> readFeatureList() {
    using List = std::optional<prescription::PrescribedFeatures>;
    if (a_.features.empty()) return List();
    Result<io::Bytes> bytes = readFile(a_.features, a_.load.limits.maxBytes);
    if (!bytes) return bytes.error();
    const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
    Result<prescription::PrescribedFeatures> read = api::readFeatures(withoutGz(a_.features), text);
    if (!read) {
      Failure failure = read.error();
      failure.message = a_.features + ": " + failure.message;
      return failure;
    }
    return List(std::move(*read));
  }

  /// The prescription from the options; empty if they prescribe nothing.
  Result<std::optional<prescription::Prescription>> prescription() {
    std::optional<prescription::Prescription> asked;
    if (!a_.field.empty()) {
      Result<prescription::Prescription> field = readFileOf(a_.field);
      if (!field) return field.error();
      asked = std::move(*field);
    }
    if (!a_.cones.empty()) {
      Result<prescription::Prescription> cones = readFileOf(a_.cones);
      if (!cones) return cones.error();
      if (asked) cones = api::withField(std::move(*cones), std::move(*asked));
      if (!cones) return cones.error();
      asked = std::move(*cones);
    }
    const bool isTyped =
        !a_.cone.empty() || !a_.turning.empty() || !a_.handle.empty() || a_.hasFeatures();
    if (!asked && !isTyped && !a_.ignoresEmbedded) {
      Result<std::optional<prescription::Prescription>> embedded = session_.embeddedCones();
      if (!embedded) return embedded.error();
      if (*embedded && (!a_.q || *a_.q == (*embedded)->q)) {
        asked = std::move(**embedded);
        asked->notes.push_back(Note("cones-of-input"));
      }
    }
    if (!asked && isTyped) {
      asked.emplace();
      asked->q = a_.q.value_or(4);
      asked->hasCones = !a_.cone.empty() || !a_.turning.empty() || !a_.handle.empty();
    }
    if (!asked) return asked;
    for (const auto& [v, k] : a_.cone) {
      asked->hasCones = true;
      asked->cones.push_back({v, k, std::nullopt});
    }
    for (const auto& [loop, l] : a_.turning) asked->boundaries.push_back({loop, l, -1});
    for (const auto& [g, r] : a_.handle) asked->handles.push_back({g, r});
    if (Status done = addFeatures(asked->features); !done) return done.error();
    return asked;
  }

  int check() {
    Result<std::optional<prescription::Prescription>> asked = prescription();
    if (!asked) return fail(asked.error());
    prescription::Prescription empty;
    empty.q = a_.q.value_or(4);
    Result<api::Verdict> verdict = session_.check(*asked ? **asked : empty);
    if (!verdict) return fail(verdict.error());
    return finish(publish(verdict->json, checkText(verdict->json, style_)),
                  verdict->isGood ? 0 : exitCode(ErrorCode::kPrescription));
  }

  /// The cones of --transfer on this mesh; what has no place on it is said.
  Result<std::string> transferred(const prescription::Prescription& cones) {
    Result<io::FileSet> files = openFiles(a_.from, "", a_.root, a_.load.limits.maxBytes);
    if (!files) return files.error();
    api::Session from;
    if (Status loaded = from.load(std::move(*files), a_.load); !loaded) return loaded.error();
    Result<api::MovedCones> moved = session_.transfer(cones, from);
    if (!moved) return moved.error();
    tell(moved->lost);
    return std::move(moved->json);
  }

  Result<std::string> askedCones() {
    if (!a_.transfer.empty() || !a_.balance.empty() || !a_.convert.empty()) {
      Result<prescription::Prescription> read = readFileOf(!a_.transfer.empty()  ? a_.transfer
                                                           : !a_.balance.empty() ? a_.balance
                                                                                 : a_.convert);
      if (!read) return read.error();
      if (!a_.transfer.empty()) return transferred(*read);
      return a_.balance.empty() ? session_.convert(*read) : session_.balance(*read);
    }
    api::SolveOptions options = a_.solve;
    options.progress = progress_.callback();
    Result<api::SuggestedCones> chosen = session_.suggest(options);
    if (!chosen) return chosen.error();
    tell(chosen->notes);
    return std::move(chosen->json);
  }

  int cones() {
    const Result<std::string> json = askedCones();
    progress_.clear();
    if (!json) return fail(json.error());
    const bool isFile = !a_.output.empty() && a_.output != "-";
    if (!a_.json.empty()) {
      if (Status done = writeText(a_.json, *json); !done) return fail(done.error());
    }
    if (a_.json == "-" && !isFile) return 0;
    return finish(writeText(isFile ? a_.output : "-", *json), 0);
  }

  int features() {
    prescription::Prescription asked;
    if (Status done = addFeatures(asked.features); !done) return fail(done.error());
    if (!a_.hasFeatures()) asked.features.creaseDegrees = kCreaseDegrees;
    const bool isFile = !a_.output.empty() && a_.output != "-";
    Result<api::FeatureList> list = session_.features(asked, isFile ? a_.output : "features.json");
    if (!list) return fail(list.error());
    if (!a_.isQuiet) {
      tell(counted(list->creaseEdges, "crease edge") + " and " +
           counted(list->rimEdges, "rim edge") + " in " + counted(list->chains, "chain"));
      for (const Note& note : list->notes) tell(phrase(note));
    }
    if (!a_.json.empty()) {
      Result<api::FeatureList> json = session_.features(asked, "features.json");
      if (!json) return fail(json.error());
      if (Status done = writeText(a_.json, json->text); !done) return fail(done.error());
      if (a_.json == "-" && !isFile) return 0;
    }
    return finish(writeText(isFile ? a_.output : "-", list->text), 0);
  }

  int wholeFile() {
    const int count = session_.surfaceCount();
    if (a_.command == Command::kParam && a_.solve.refines) {
      return fail(
          {ErrorCode::kUsage,
           "refine",
           formatText("--refine is for one mesh and the file has %d: choose with --mesh N", count),
           {}});
    }
    if (a_.command == Command::kParam) {
      if (Status possible = session_.canWrite(a_.output); !possible) return fail(possible.error());
    }
    Result<FileOutcome> outcome = a_.command == Command::kParam
                                      ? parametrizeAll(session_, a_, progress_.callback())
                                      : verifyAll(session_, a_);
    if (!outcome) return fail(inTime(outcome.error()));
    const bool isMessage = a_.command == Command::kParam;
    if (Status done = publish(outcome->json(), outcome->text(), isMessage); !done) {
      return fail(done.error());
    }
    const bool isWhole = outcome->goodCount() == count;
    if (!isMessage) return isWhole ? 0 : kNoMapExit;
    if (!isWhole && !a_.solve.keepsGoing && !a_.write.allowUncertified) {
      tell("nothing was written; --keep-going writes what is certified");
      return kNoMapExit;
    }
    if (outcome->files.empty()) {
      tell("nothing was written: no mesh has a map");
      return kNoMapExit;
    }
    Notes more;
    const Status finished = finishFiles(outcome->files, more, resolve_, a_);
    if (!finished) return fail(finished.error());
    for (const Note& note : more) outcome->notes.push_back(phrase(note));
    if (Status done = writeFiles(a_.output, outcome->files); !done) return fail(done.error());
    tellWritten(outcome->notes);
    return isWhole ? 0 : notCertified();
  }

  /// The failure, or kNoMap if --time-limit ended the run.
  Failure inTime(Failure failure) const {
    if (progress_.isTimedOut()) {
      failure.code = ErrorCode::kNoMap;
      failure.message = formatText("no certified map within %g s (--time-limit)", *a_.timeLimit);
    }
    return failure;
  }

  void tellWritten(const std::vector<std::string>& lines) const {
    if (a_.isQuiet) return;
    for (const std::string& line : lines) {
      std::fprintf(stderr, "  note: %s\n", printable(line).c_str());
    }
    std::fprintf(stderr, "  wrote %s\n", printable(a_.output).c_str());
  }

  int param() {
    const bool isQuads = a_.command == Command::kQuads;
    if (Status possible = session_.canWrite(a_.output); !possible && !isQuads) {
      return fail(possible.error());
    }
    if (a_.isCompressed && !session_.canWrite("x.glb") && !session_.canWrite("x.gltf")) {
      return fail({ErrorCode::kUsage,
                   "write",
                   "--compress is for glTF, and this is written as another format: name the result "
                   "-o x.glb or -o x.gltf",
                   {}});
    }
    if (Status possible = api::canWriteQuads(a_.output); !possible && isQuads) {
      return fail(possible.error());
    }
    Result<std::optional<prescription::Prescription>> asked =
        std::optional<prescription::Prescription>();
    if (a_.solve.boundary != api::BoundaryKind::kConvex) asked = prescription();
    if (!asked) return fail(asked.error());
    api::SolveOptions options = a_.solve;
    options.progress = progress_.callback();
    if (Status solved = session_.parametrize(*asked, options); !solved) {
      return fail(inTime(solved.error()));
    }
    const std::string& report = session_.reportJson();
    if (Status done = publish(report, a_.isQuiet ? "" : reportText(report, messageStyle_), true);
        !done) {
      return fail(done.error());
    }
    if (!session_.isCertified() && !a_.write.allowUncertified && !a_.solve.keepsGoing) {
      tell("nothing was written; --keep-going writes the components that are certified");
      return kNoMapExit;
    }
    if ((a_.solve.choosesCells || a_.solve.grid.isAsked()) && !session_.isAligned()) {
      tell("the map is certified but not aligned to a grid; nothing was written");
      return kNoMapExit;
    }
    return isQuads ? writeQuads() : writeResult();
  }

  int writeQuads() {
    Result<QuadFiles> made = makeQuadFiles(session_, resolve_, a_);
    if (!made) return fail(made.error());
    if (Status done = writeFiles(a_.output, made->files); !done) return fail(done.error());
    if (!a_.isQuiet) reportQuads(a_.output, made->quads);
    return 0;
  }

  int writeResult() {
    api::WriteOptions options = a_.write;
    options.name = a_.output;
    options.isSideFileNoted = false;
    options.isCompressedLater = a_.isCompressed;
    options.allowUncertified = options.allowUncertified || a_.solve.keepsGoing;
    Result<api::WrittenMap> written = session_.write(options);
    if (!written) return fail(written.error());
    const Status finished = finishFiles(written->files, written->notes, resolve_, a_);
    if (!finished) return fail(finished.error());
    Result<std::vector<AlsoFile>> also = makeAlso(session_, a_);
    if (!also) return fail(also.error());
    const bool areCertified = std::all_of(
        also->begin(), also->end(), [](const AlsoFile& file) { return file.written.isCertified; });
    if (Status done = writeFiles(a_.output, written->files); !done) return fail(done.error());
    std::vector<std::string> lines;
    for (const Note& note : written->notes) lines.push_back(phrase(note));
    if (Status done = writeAlso(*also, lines); !done) {
      return fail(done.error());
    }
    if (!a_.faces.empty()) {
      if (Status done = writeFaces(session_, a_.faces); !done) return fail(done.error());
    }
    if (!a_.xref.empty()) {
      std::string text;
      if (!written->xref.empty()) {
        for (int v : written->xref) text += std::to_string(v) + "\n";
      } else {
        for (std::uint32_t v : session_.uvToVertex()) text += std::to_string(v) + "\n";
      }
      if (Status done = writeText(a_.xref, text); !done) return fail(done.error());
    }
    tellWritten(lines);
    return session_.isCertified() && areCertified ? 0 : notCertified();
  }

  int verify() {
    Result<std::optional<prescription::Prescription>> asked = prescription();
    if (!asked) return fail(asked.error());
    Result<api::Verdict> verdict = session_.verify(*asked, a_.verify);
    if (!verdict) return fail(verdict.error());
    return finish(publish(verdict->json, certificateText(verdict->json, style_)),
                  verdict->isGood ? 0 : kNoMapExit);
  }

  const Arguments& a_;
  api::Session session_;
  io::Resolver resolve_;  ///< for the input's side files
  ProgressLine progress_;
  Style style_, messageStyle_;  ///< for standard output and standard error
};

}  // namespace

int runCommand(const Arguments& arguments) { return Run(arguments).run(); }

}  // namespace hgp::cli
